#include <filesystem>

#include "checks.hpp"
#include "common/program.hpp"

namespace verify::story {
namespace {

int run(const std::filesystem::path& folder) {
  Record record("story");
  tell_events(folder, record);
  return record.finish(folder / "parts");
}

}  // namespace
}  // namespace verify::story

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, verify::story::run); }
