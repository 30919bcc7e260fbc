#include "manual_page.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace carom {
namespace {

/// Returns text such that troff prints it as it is. Each line must begin where troff's line begins.
std::string escaped(std::string_view text) {
  std::string troff;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool beginsLine = i == 0 || text[i - 1] == '\n';
    if (beginsLine && (text[i] == '.' || text[i] == '\'')) troff += "\\&";
    if (text[i] == '-') {
      troff += "\\-";
    } else if (text[i] == '\\') {
      troff += "\\e";
    } else if (text[i] == '"') {
      troff += "\\(dq";
    } else {
      troff += text[i];
    }
  }
  return troff;
}

/// Returns the name of an option's value without its limits: "N" of "N:INT in [1 - 10]".
std::string valueOf(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type.substr(0, type.find(':'));
}

std::string paragraph(const std::string& description) {
  return description.empty() ? "" : escaped(description) + ".\n";
}

std::string ofOption(const CLI::Option& option) {
  const std::string name = escaped("--" + option.get_lnames().front());
  const std::string value = escaped(valueOf(option));
  const std::string head =
      value.empty() ? fmt::format(".TP\n.B {}\n", name) : fmt::format(".TP\n.BI {} \" {}\"\n", name, value);
  return head + paragraph(option.get_description());
}

/// `before`: the command of which this one is a part, or empty.
std::string ofCommand(const CLI::App& command, const std::string& before = "") {
  std::string usage = before + command.get_name(), positionals, options;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) {
      const std::string name = option->get_name(true);
      usage += option->get_required() ? " " + name : " [" + name + "]";
      positionals += fmt::format(".TP\n.I {}\n", escaped(name)) + paragraph(option->get_description());
    } else if (option->get_lnames().front().find("help") != 0) {
      options += ofOption(*option);
    }
  }
  std::string examples = command.get_footer();
  if (!examples.empty()) examples = ".PP\n.EX\n" + escaped(examples) + "\n.EE\n";
  return fmt::format(".SS \"carom {}\"\n{}", escaped(usage), paragraph(command.get_description())) +
         positionals + options + examples;
}

}  // namespace

std::string manualOfCommands(const CLI::App& app) {
  std::string page;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    page += ofCommand(*command);
    for (const CLI::App* part : command->get_subcommands([](const CLI::App*) { return true; }))
      page += ofCommand(*part, command->get_name() + " ");
  }
  return page;
}

}  // namespace carom
