#include "contensou/scene/read_measures.hpp"

#include <catch2/catch.hpp>

#include "bodies_scene.hpp"
#include "contensou/scene/columns.hpp"

using namespace contensou;
using namespace contensou::test;

TEST_CASE("Outcomes: every key arrives, in the order of the file", "[scene]") {
  const std::vector<MeasureScene> measures = changed({}).measures;
  REQUIRE(measures.size() == 4);
  CHECK((measures[0].name == "end" && measures[0].kind == MeasureScene::Kind::final));
  CHECK(measures[0].column == "top.z");
  CHECK((measures[1].kind == MeasureScene::Kind::crossing && measures[1].value == 1.5));
  CHECK((measures[2].kind == MeasureScene::Kind::event && measures[2].event == "stick"));
  CHECK((measures[2].contact == "pile_3" && measures[2].occurrence == 2));
  CHECK((measures[3].kind == MeasureScene::Kind::count && measures[3].contact == "hulls_1"));
  for (const char* kind : {"minimum", "maximum", "trajectory"})
    CHECK(name(changed({{}, {"outcome.end.kind=" + std::string(kind)}}).measures[0].kind) ==
          std::string(kind));
}

TEST_CASE("Outcomes: what they look at is in the trajectory", "[scene]") {
  CHECK(columns(changed({})) ==
        std::vector<std::string>{"top.x", "pile.5.z", "gap_top", "slip_slide", "energy", "top.z", "highest"});
  CHECK(columns(changed({{"output.columns"}, {}})) ==
        std::vector<std::string>{"highest", "energy", "top.z"});  // nine bodies
}

TEST_CASE("Outcomes and columns: what is not there is refused", "[scene]") {
  const std::vector<Refused> cases{
      {{{}, {"outcome.end.kind=last"}}, {"\"last\" is unknown", "\"trajectory\""}},
      {{{}, {"outcome.end.column=top.q"}},
       {"--set outcome.end.column: \"top.q\" is no column here", "BODY.x"}},
      {{{}, {"outcome.end.column=t"}}, {"is no column"}},
      {{{}, {"outcome.end.column=gap_pile"}}, {"is no column"}},      // ten pairs
      {{{}, {"outcome.end.column=slip_walls_1"}}, {"is no column"}},  // no friction
      {{{}, {"outcome.end.column=spin_slide"}}, {"is no column"}},    // no drilling
      {{{}, {"outcome.end.value=1"}}, {"outcome.end.value: 1 is not used by kind final"}},
      {{{}, {"outcome.end.event=close"}}, {"not used by kind final"}},
      {{{}, {"outcome.hits.occurrence=1"}}, {"not used by kind count"}},
      {{{}, {"outcome.hits.column=energy"}}, {"not used by kind count"}},
      {{{}, {"outcome.third.occurrence=0"}}, {"outcome.third.occurrence: 0", "from 1"}},
      {{{}, {"outcome.third.event=bounce"}}, {"\"bounce\" is unknown", "\"accumulation\""}},
      {{{}, {"outcome.third.contact=pile"}}, {"\"pile\" is no contact here", "one of top slide pile_1"}},
      {{{}, {"outcome.third.contact=pile_11"}}, {"is no contact here"}},
      {{{}, {"output.columns=[]"}}, {"output.columns: []", "array of names"}},
      {{{}, {"output.columns=['energy','energy']"}}, {"names \"energy\" twice"}},
      {{{}, {"output.columns=['energy','pile.6.x']"}}, {"names \"pile.6.x\""}},
      {{{}, {"output.columns=energy"}}, {"is not an array of strings"}},
      {{{"output.columns"}, {"integrator.method=nscd", "integrator.step=1e-3"}},
       {"outcome.third.kind", "no events"}},
      {{{}, {"integrator.method=nscd", "integrator.step=1e-3"}}, {"output.columns", "\"gap_top\""}},
      {{{"outcome"}, {"integrator.method=nscd", "integrator.step=1e-3", "output.columns=['contacts']"}},
       {"names \"contacts\""}},
  };
  for (const Refused& refused : cases) CHECK(check_refused(refused) == "");
  // 101 columns in 1e6 rows.
  std::string many = "output.columns=['energy'";
  for (int i = 1; i <= 100; ++i) many += ", 'pile." + std::to_string(i) + ".x'";
  CHECK(check_refused({{{"outcome"},
                        {many + ']', "output.interval=1e-6", "balls.pile.count=100", "integrator.method=nscd",
                         "integrator.step=1e-3"}},
                       {"--set output.interval: 1e-6 makes more than 1e8 numbers"}}) == "");
  CHECK(refusal({{}, {"outcome.end.column=gap_walls_15"}}).empty());
  CHECK(refusal({{}, {"outcome.end.column=spin_hulls_2"}}).empty());
}
