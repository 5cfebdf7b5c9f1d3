#include "contensou/output/file.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "test_folder.hpp"

using namespace contensou;
using namespace test_folder;
namespace fs = std::filesystem;

TEST_CASE("Files that belong together are written together", "[output]") {
  const Folder folder;
  const fs::path there = folder.path / "new" / "folder";
  write_files({{there / "a", "1"}, {there / "b", std::string_view("2\0", 2)}, {there / "c", ""}});
  CHECK(contents(there / "a") == "1");
  CHECK(contents(there / "b") == std::string("2\0", 2));
  CHECK(contents(there / "c").empty());
  CHECK(entries(there) == 3);
}

TEST_CASE("Where one of the files cannot be written, the others stay as they were", "[output]") {
  const Folder folder;
  write_files({{folder.path / "a", "old"}});
  fs::create_directory(folder.path / "b");
  CHECK_THROWS_AS(write_files({{folder.path / "a", "new"}, {folder.path / "b", "new"}}), std::runtime_error);
  CHECK_THROWS_AS(write_files({{folder.path / "a", "new"}, {folder.path / "a" / "c", "new"}}),
                  std::runtime_error);
  CHECK_THROWS_AS(write_files({{folder.path / "a", "new"}, {"/dev/null", "new"}}), std::runtime_error);
  CHECK(contents(folder.path / "a") == "old");
  CHECK(entries(folder.path) == 2);
}
