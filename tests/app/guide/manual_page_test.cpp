// The manual page of commands, in the language of troff.
#include "app/guide/manual_page.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <string>

namespace carom {
namespace {

TEST(ManualPage, HasEveryCommandWithItsArgumentsOptionsAndExamples) {
  CLI::App app;
  CLI::App* const weigh = app.add_subcommand("weigh", "Weigh a puck");
  std::string file;
  int times = 0;
  bool quick = false;
  weigh->add_option("FILE", file, "The puck")->required();
  weigh->add_option("TABLE", file, "Its table");
  weigh->add_option("--times,-n", times, "How often")->check(CLI::Range(1, 10))->type_name("N");
  weigh->add_flag("--quick-look", quick, "Do not wait");
  weigh->footer("Examples:\n  carom weigh puck.toml");
  EXPECT_EQ(manualOfCommands(app),
            ".SS \"carom weigh FILE [TABLE]\"\nWeigh a puck.\n"
            ".TP\n.I FILE\nThe puck.\n.TP\n.I TABLE\nIts table.\n"
            ".TP\n.BI \\-\\-times \" N\"\nHow often.\n"
            ".TP\n.B \\-\\-quick\\-look\nDo not wait.\n"
            ".PP\n.EX\nExamples:\n  carom weigh puck.toml\n.EE\n");
}

TEST(ManualPage, PartsOfACommandFollowIt) {
  CLI::App app;
  CLI::App* const link = app.add_subcommand("link", "Link rooms");
  link->add_subcommand("key", "Make a key");
  link->add_subcommand("try", "Try a line");
  app.add_subcommand("list", "List games");
  EXPECT_EQ(manualOfCommands(app),
            ".SS \"carom link\"\nLink rooms.\n.SS \"carom link key\"\nMake a key.\n"
            ".SS \"carom link try\"\nTry a line.\n.SS \"carom list\"\nList games.\n");
}

// What troff would take for its own is printed as it is: lines that begin with a dot or an apostrophe,
// backslashes, quotes, and dashes, which it would make hyphens.
TEST(ManualPage, TextIsPrintedAsItIs) {
  CLI::App app;
  app.add_subcommand("say", ".hidden 'a\\b' \"c\"")->footer("'x\na.b\n.y - z");
  EXPECT_EQ(manualOfCommands(app),
            ".SS \"carom say\"\n\\&.hidden 'a\\eb' \\(dqc\\(dq.\n"
            ".PP\n.EX\n\\&'x\na.b\n\\&.y \\- z\n.EE\n");
}

}  // namespace
}  // namespace carom
