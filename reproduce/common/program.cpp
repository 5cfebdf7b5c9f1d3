#include "program.hpp"

#include <cstdio>
#include <exception>
#include <string>
#include <string_view>

namespace reproduce {

int program_main(int argc, char** argv, const std::function<int(const std::filesystem::path& folder)>& run) {
  const std::string name = std::filesystem::path(argv[0]).filename().string();
  std::filesystem::path folder = "build/report/data";
  if (argc == 3 && std::string_view(argv[1]) == "--out") {
    folder = argv[2];
  } else if (argc != 1) {
    std::fprintf(stderr, "usage: %s [--out FOLDER]\n", name.c_str());
    return 2;
  }
  try {
    return run(folder);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
    return 1;
  }
}

}  // namespace reproduce
