#include "contensou/output/table.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>

#include "test_folder.hpp"

using namespace contensou;
using namespace test_folder;
namespace fs = std::filesystem;

TEST_CASE("Numbers read back to the same double", "[output][table]") {
  const Folder folder;
  Table table{.comments = {"units: none"}, .columns = {"x"}, .rows = {}};
  std::vector<double> values{0.0,
                             -0.0,
                             1.0 / 3,
                             -std::numeric_limits<double>::max(),
                             std::numeric_limits<double>::min(),
                             std::numeric_limits<double>::denorm_min(),
                             2.5e-320,
                             std::nextafter(1.0, 2.0),
                             std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()};
  std::mt19937_64 random(3);
  while (values.size() < 1000) {
    const double x = std::bit_cast<double>(random());
    if (std::isfinite(x)) values.push_back(x);
  }
  for (const double x : values) table.add({x});
  write_table(table, folder.path / "numbers.tsv");
  const auto back = read_table(folder.path / "numbers.tsv").numbers("x");
  REQUIRE(back.size() == values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    CHECK(std::bit_cast<std::uint64_t>(back[i]) == std::bit_cast<std::uint64_t>(values[i]));
  }
}

TEST_CASE("A table is comments, names, rows", "[output][table]") {
  const Folder folder;
  Table table{.comments = {"two columns", "", "# and a hash"}, .columns = {"name", "value"}, .rows = {}};
  table.add({"uniform", 0.25});
  table.add({"digits", std::string("3.141592653589793238462643383279502884")});
  table.add({"", 1e-300});
  write_table(table, folder.path / "new" / "folders" / "a.tsv");
  CHECK(contents(folder.path / "new" / "folders" / "a.tsv") ==
        "# two columns\n#\n# # and a hash\nname\tvalue\nuniform\t0.25\n"
        "digits\t3.141592653589793238462643383279502884\n\t1e-300\n");
  const Table back = read_table(folder.path / "new" / "folders" / "a.tsv");
  CHECK(back.comments == table.comments);
  CHECK(back.columns == table.columns);
  CHECK(back.rows == table.rows);
  CHECK(back.texts("name") == std::vector<std::string>{"uniform", "digits", ""});
  CHECK(back.column("value") == 1);
  CHECK(entries(folder.path / "new" / "folders") == 1);  // no temporary file left
}

TEST_CASE("Writing replaces the old file as a whole", "[output][table]") {
  const Folder folder;
  write_file("old and longer", folder.path / "f.txt");
  write_file("new", folder.path / "f.txt");
  CHECK(contents(folder.path / "f.txt") == "new");
  CHECK(entries(folder.path) == 1);
}

TEST_CASE("Rows that do not fit are refused", "[output][table]") {
  Table table{.comments = {}, .columns = {"a", "b"}, .rows = {}};
  CHECK_THROWS_AS(table.add({1.0}), std::logic_error);
  CHECK_THROWS_AS(table.add({1.0, 2.0, 3.0}), std::logic_error);
  CHECK_THROWS_AS(table.add({"tab\there", 2.0}), std::invalid_argument);
  CHECK_THROWS_AS(table.add({"line\nbreak", 2.0}), std::invalid_argument);
  CHECK_THROWS_AS(table.add({"line\rbreak", 2.0}), std::invalid_argument);
  CHECK(table.rows.empty());
}

TEST_CASE("Columns that are not there, cells that are no numbers", "[output][table]") {
  Table table{.comments = {}, .columns = {"a"}, .rows = {}};
  table.add({1.0});
  table.add({"two"});
  CHECK_THROWS_WITH(table.column("b"), Catch::Contains("'b'"));
  CHECK_THROWS_AS(table.column("b"), std::out_of_range);
  CHECK_THROWS_WITH(table.numbers("a"), Catch::Contains("column 'a', row 2: 'two'"));
  CHECK_THROWS_AS(table.numbers("a"), std::invalid_argument);
  for (const char* text : {"", "1 ", " 1", "1e999", "0x10", "1,5"}) {
    CAPTURE(text);
    Table bad{.comments = {}, .columns = {"a"}, .rows = {{text}}};
    CHECK_THROWS_AS(bad.numbers("a"), std::invalid_argument);
  }
}

TEST_CASE("Bad files are named with the line", "[output][table]") {
  const Folder folder;
  const fs::path path = folder.path / "bad.tsv";
  CHECK_THROWS_WITH(read_table(path), Catch::Contains("bad.tsv: cannot be opened"));
  write_file("", path);
  CHECK_THROWS_WITH(read_table(path), Catch::Contains("no table in it"));
  write_file("# only a comment\n", path);
  CHECK_THROWS_WITH(read_table(path), Catch::Contains("no table in it"));
  write_file("# c\na\tb\n1\t2\n3\n", path);
  CHECK_THROWS_WITH(read_table(path), Catch::Contains("bad.tsv:4: 1 cells, expected 2"));
  write_file("a\tb\n1\t2\t3\n", path);
  CHECK_THROWS_WITH(read_table(path), Catch::Contains("bad.tsv:2: 3 cells, expected 2"));
  CHECK_THROWS_AS(read_table(folder.path), std::runtime_error);
}

TEST_CASE("What cannot be written leaves nothing behind", "[output][table]") {
  const Folder folder;
  // A file stands where a folder should be: no privilege gets past that, not even root's.
  write_file("in the way", folder.path / "file");
  CHECK_THROWS_WITH(write_file("x", folder.path / "file" / "table.tsv"),
                    Catch::Contains("table.tsv: cannot be written"));
  CHECK(contents(folder.path / "file") == "in the way");
  // A folder stands where the file should be: written beside, not renamed, and removed again.
  fs::create_directories(folder.path / "taken" / "inside");
  CHECK_THROWS_AS(write_file("x", folder.path / "taken"), std::runtime_error);
  CHECK(entries(folder.path) == 2);
  CHECK(fs::is_directory(folder.path / "taken" / "inside"));
}

TEST_CASE("A link stays a link, what it leads to is replaced", "[output][table]") {
  const Folder folder;
  write_file("old", folder.path / "real");
  fs::create_symlink("real", folder.path / "link");
  write_file("new", folder.path / "link");
  CHECK(fs::is_symlink(folder.path / "link"));
  CHECK(contents(folder.path / "real") == "new");

  fs::create_symlink("nowhere", folder.path / "dangling");
  CHECK_THROWS_WITH(write_file("x", folder.path / "dangling"), Catch::Contains("cannot be written"));
  CHECK(fs::is_symlink(fs::symlink_status(folder.path / "dangling")));
  CHECK(entries(folder.path) == 3);
}
