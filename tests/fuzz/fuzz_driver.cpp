// Runs a libFuzzer target without libFuzzer: every kept input, then mutations of them, the same ones in every
//   run. TARGET [-runs=N] [-seed=N] [-max_len=N] FOLDER…

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "mutate.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

namespace {

using carom::test::Bytes;

struct Options {
  std::size_t runs = 20000, seed = 1, longest = 4096;
  std::vector<std::filesystem::path> folders;
};

Options read(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    const auto number = [&](std::string_view name, std::size_t& value) {
      if (!argument.starts_with(name)) return false;
      std::from_chars(argument.data() + name.size(), argument.data() + argument.size(), value);
      return true;
    };
    if (number("-runs=", options.runs) || number("-seed=", options.seed) ||
        number("-max_len=", options.longest)) {
      continue;
    }
    options.folders.emplace_back(argument);
  }
  return options;
}

std::vector<Bytes> keptInputs(const std::vector<std::filesystem::path>& folders) {
  std::vector<std::filesystem::path> files;
  for (const auto& folder : folders) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<Bytes> inputs;
  for (const auto& file : files) {
    std::ifstream in(file, std::ios::binary);
    inputs.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return inputs;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = read(argc, argv);
  const std::vector<Bytes> inputs = keptInputs(options.folders);
  if (inputs.empty()) {
    std::fprintf(stderr, "no kept inputs found, expected a folder of them\n");
    return 1;
  }
  for (const Bytes& input : inputs) LLVMFuzzerTestOneInput(input.data(), input.size());
  std::mt19937_64 random(options.seed);
  for (std::size_t run = 0; run < options.runs; ++run) {
    const Bytes& one = inputs[random() % inputs.size()];
    const Bytes& other = inputs[random() % inputs.size()];
    Bytes input = carom::test::mutated(one, other, random);
    input.resize(std::min(input.size(), options.longest));
    LLVMFuzzerTestOneInput(input.data(), input.size());
  }
  std::printf("%zu kept inputs, %zu mutations\n", inputs.size(), options.runs);
  return 0;
}
