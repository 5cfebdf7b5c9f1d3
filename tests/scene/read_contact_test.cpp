#include "contensou/scene/read_contact.hpp"

#include <catch2/catch.hpp>

#include "bodies_scene.hpp"

using namespace contensou;
using namespace contensou::test;

TEST_CASE("Contact: a radius that follows the load", "[scene]") {
  const Scene scene = changed({{},
                               {"contact.hulls.radius=hertz", "contact.hulls.modulus=2e9",
                                "integrator.method=moreau", "integrator.step=1e-3"}});
  const ContactScene& contact = bodies_of(scene).contacts[4];
  CHECK(contact.modulus == 2e9);
  CHECK(contact.rows() == 4);
}

TEST_CASE("Contact: what its law or its method does not know is refused", "[scene]") {
  const std::vector<Refused> cases{
      {{{"contact.slide.mu"}, {}}, {"f.toml:83: contact.slide.mu is missing"}},
      {{{"contact.hulls.pressure"}, {}}, {"contact.hulls.pressure is missing"}},
      {{{}, {"contact.slide.radius=1"}}, {"contact.slide.radius: 1 is not used by law coulomb"}},
      {{{}, {"contact.walls.mu=1"}}, {"not used by law frictionless"}},
      {{{}, {"contact.hulls.modulus=1"}}, {"contact.hulls.modulus: 1 is not used by a radius that is given"}},
      {{{}, {"contact.hulls.radius=hertz"}}, {"contact.hulls.modulus is missing"}},
      {{{}, {"contact.hulls.radius=wide"}}, {"contact.hulls.radius: \"wide\"", "\"hertz\""}},
      {{{}, {"contact.hulls.radius=hertz", "contact.hulls.modulus=1e9"}},
       {"contact.hulls.radius: \"hertz\" is not for method event_driven", "moreau"}},
      {{{}, {"contact.hulls.model=uncoupled"}}, {"contact.hulls.model", "not for method event_driven"}},
      {{{}, {"contact.hulls.model=series"}}, {"\"series\" is unknown"}},
      {{{}, {"contact.hulls.pressure=parabolic"}}, {"contact.hulls.pressure", "is no pressure"}},
      {{{}, {"contact.hulls.table_radius=[0,1]"}}, {"table_radius", "not used by pressure uniform"}},
      {{{}, {"contact.top.table_radius=[0,0.5]"}}, {"contact.top.table_pressure", "3 entries", "expected 2"}},
      {{{}, {"contact.top.table_radius=[0,0.5,0.9]"}}, {"contact.top.table_radius", "makes no pressure"}},
      {{{}, {"contact.top.table_radius=[0,1,0.5]"}}, {"contact.top.table_radius", "makes no pressure"}},
      {{{}, {"contact.top.table_radius=[0,0.5,2]"}}, {"contact.top.table_radius", "holds 2"}},
      {{{}, {"contact.top.table_pressure=[1,-1,0]"}}, {"contact.top.table_pressure", "holds -1"}},
      {{{}, {"contact.top.table_pressure=[0,0,0]"}}, {"contact.top.table_radius", "makes no pressure"}},
      {{{}, {"contact.top.table_pressure=[]"}}, {"0 entries"}},
      {{{}, {"contact.pile.restitution=1.5"}}, {"contact.pile.restitution", "from 0 to 1"}},
      {{{}, {"integrator.method=rk4_printed", "integrator.step=1e-3"}},
       {"contact.pile.restitution: 0.5 is not for method rk4_printed"}},
      {{{}, {"integrator.threads=2"}}, {"integrator.threads: 2 is not used by method event_driven"}},
      {{{}, {"scene.fidelity=0.001"}}, {"scene.fidelity", "not used by method event_driven"}},
      {{{}, {"scene.fidelity=1", "integrator.method=moreau"}}, {"scene.fidelity: 1", "between 0 and 1"}},
      {{{}, {"integrator.threads=1.5", "integrator.method=nscd"}}, {"integrator.threads: 1.5 is not whole"}},
  };
  for (const Refused& refused : cases) CHECK(check_refused(refused) == "");
}

TEST_CASE("Contact: settings of nscd", "[scene]") {
  const Scene scene = changed({{"output.columns", "outcome"},
                               {"integrator.method=nscd", "integrator.step=1e-3", "integrator.threads=2",
                                "scene.fidelity=0.01", "contact.hulls.model=uncoupled"}});
  CHECK(scene.threads == 2);
  CHECK(scene.fidelity == 0.01);
  CHECK(scene.integrator.fidelity == 0.01);
  CHECK(scene.integrator.solver_tolerance == 1e-8);
  CHECK(changed({}).integrator.solver_tolerance == 1e-12);
  CHECK(changed({}).threads == 1);
}
