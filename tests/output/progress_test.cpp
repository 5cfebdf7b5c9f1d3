#include "contensou/output/progress.hpp"

#include <catch2/catch.hpp>
#include <sstream>

using namespace contensou;

TEST_CASE("Progress: silent for a second, then how far and how long still", "[output]") {
  std::ostringstream terminal;
  {
    Progress progress(terminal, 0, 8);
    progress.show(1, 0.5);
    CHECK(terminal.str().empty());
    progress.show(2, 3);  // a quarter in 3 s: the rest takes 9
    CHECK(terminal.str() == "\rt = 2 of 8 s, 25 %, 9 s left\x1b[K");
    progress.show(3, 3.1);  // too soon to be read
    CHECK(terminal.str().ends_with("9 s left\x1b[K"));
    progress.show(6, 4.5);
    CHECK(terminal.str().ends_with("\rt = 6 of 8 s, 75 %, 2 s left\x1b[K"));
  }
  CHECK(terminal.str().ends_with("\r\x1b[K"));
}

TEST_CASE("Progress: a short run shows nothing, one without a beginning no time left", "[output]") {
  std::ostringstream terminal;
  {
    Progress progress(terminal, 0, 8);
    progress.show(4, 0.2);
    progress.show(8, 0.9);
  }
  CHECK(terminal.str().empty());
  Progress progress(terminal, 2, 8);
  progress.show(2, 5);
  CHECK(terminal.str() == "\rt = 2 of 8 s, 25 %\x1b[K");
}

TEST_CASE("Progress: of many runs, some of them done before", "[output]") {
  std::ostringstream terminal;
  Progress progress(terminal, 400, 1600, "", " runs");
  progress.show(700, 2);  // a quarter of the 1200 that were left
  CHECK(terminal.str() == "\r700 of 1600 runs, 44 %, 6 s left\x1b[K");
  Progress many(terminal, 0, 1e6, "", " runs");
  many.show(123456, 1.5);
  CHECK_THAT(terminal.str(), Catch::Contains("\r123456 of 1000000 runs, 12 %"));
}

TEST_CASE("Progress: long times in minutes and hours", "[output]") {
  for (const auto& [elapsed, left] : {std::pair(180.0, "180 s left"),
                                      {200.0, "4 min left"},
                                      {7000.0, "117 min left"},
                                      {7200.0, "2.0 h left"}}) {
    std::ostringstream terminal;
    Progress progress(terminal, 0, 2);
    progress.show(1, elapsed);
    CHECK_THAT(terminal.str(), Catch::Contains(left));
  }
}
