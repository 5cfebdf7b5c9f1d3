#include "absent/callgrind.hpp"

#include <catch2/catch.hpp>

#include "absent/code_groups.hpp"
#include "absent/counting.hpp"
#include "contensou/output/file.hpp"

using namespace verify::absent;

TEST_CASE("Counting: the name of a function without its type and arguments", "[absent]") {
  for (const auto& [demangled, name] :
       {std::pair{"main", "main"}, std::pair{"contensou::f(int, double)", "contensou::f"},
        std::pair{"double contensou::f<std::vector<int, A> >(std::vector<int, A> const&)",
                  "contensou::f<std::vector<int, A> >"},
        std::pair{"contensou::(anonymous namespace)::Kind<contensou::FrictionDisk>::border(int)",
                  "contensou::(anonymous namespace)::Kind<contensou::FrictionDisk>::border"},
        std::pair{"contensou::A<g(int)::{lambda(int)#1}>::operator()(int) const",
                  "contensou::A<g(int)::{lambda(int)#1}>::operator()"},
        std::pair{"contensou::b::f(int) [clone .isra.0]", "contensou::b::f"},
        std::pair{"void std::visit<contensou::FrictionDisk>(std::variant<contensou::FrictionDisk>&)",
                  "std::visit<contensou::FrictionDisk>"}})
    CHECK(qualified_name(demangled) == name);
}

TEST_CASE("Counting: callgrind's file, read", "[absent]") {
  // main: 10 of its own, calls f twice (30, 40) and g once; f calls g: 5 own of g each time.
  const Folder folder;
  contensou::write_file(
      "# callgrind format\nversion: 1\ncreator: callgrind-3.19.0\npositions: line\nevents: Ir\nsummary: "
      "85\n\n"
      "ob=(1) /bin/x\nfl=(1) ???\nfn=(1) main\n0 10\ncfn=(2) contensou::f(int)\ncalls=2 0\n0 70\n"
      "cob=(2) /lib/m\ncfi=(2) ???\ncfn=(3) __acos_fma\ncalls=1 0\n0 5\n\n"
      "fn=(2)\n0 50\n+3 5\ncfn=(3)\ncalls=3 0\n0 15\n\nob=(2)\nfl=(2)\nfn=(3)\n0 20\n\ntotals: 85\n",
      folder.path() / "counts");
  const Profile profile = read_profile(folder.path() / "counts");
  CHECK(profile.instructions == 85);
  CHECK(profile.functions.at("contensou::f(int)").calls == 2);
  CHECK(profile.functions.at("contensou::f(int)").instructions == 55);
  CHECK(profile.functions.at("__acos_fma").calls == 4);
  CHECK(profile.functions.at("__acos_fma").instructions == 20);
  CHECK(profile.functions.at("main").instructions == 10);
  for (const CodeGroup& group : code_groups()) {
    CAPTURE(group.name);
    CHECK(count(profile, group).calls == (group.name == "arcs" ? 4 : 0));
  }
}

TEST_CASE("Counting: which functions belong to which effect", "[absent]") {
  const auto groups_of = [](const std::string& name) {
    Profile profile;
    profile.functions[name].calls = 1;
    std::string groups;
    for (const CodeGroup& group : code_groups()) {
      if (count(profile, group).calls > 0) groups += group.name + ' ';
    }
    return groups;
  };
  CHECK(groups_of("contensou::FrictionDisk::project(Eigen::Vector2d const&, double) const") == "friction ");
  CHECK(groups_of("contensou::HertzLaw::at(double, double) const") == "law ");
  CHECK(groups_of(
            "contensou::FrictionBall<contensou::SmoothPlate<contensou::HertzLaw> >::project(int) const") ==
        "friction ball ");
  CHECK(groups_of("contensou::RigidBodies::contact_rows(unsigned long) const") == "contact ");
  CHECK(groups_of("contensou::rows(std::variant<contensou::NoFriction, contensou::FrictionDisk> const&)") ==
        "");
  CHECK(groups_of("__ieee754_acos_fma") == "arcs ");
  CHECK(groups_of("acos") == "arcs ");
  CHECK(groups_of("__cos_fma") == "");
  CHECK(groups_of("double boost::math::detail::ellint_f_imp<double>(double)") == "arcs ");
}
