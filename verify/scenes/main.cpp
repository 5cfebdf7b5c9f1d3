// The scenes that ship against their analytic answers. Writes scenes.tsv, scenes_limits.tsv, scenes_disc.tsv,
// scenes_disc_ends.tsv.   verify_scenes [--out FOLDER]

#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <string>

#include "checks.hpp"
#include "common/program.hpp"

namespace verify::answers {
namespace {

int run(const std::filesystem::path& folder) {
  Sheet sheet;
  const struct {
    const char* scene;
    std::function<void(Sheet&)> check;
  } checks[] = {{"tippe_top_bodies", check_tippe_top_bodies},
                {"sliding_disc", [&](Sheet& s) { check_sliding_disc(folder, s); }},
                {"polishing_machine", check_polishing_machine},
                {"sidespin", check_sidespin},
                {"bouncing_ball", check_bouncing_ball},
                {"free_body", check_free_body},
                {"corner", check_corner},
                {"pile", check_pile}};
  for (const auto& [scene, check] : checks) {
    try {
      check(sheet);
    } catch (const std::exception& error) {  // the other scenes have something to say, too
      std::fprintf(stderr, "%s: %s\n", scene, error.what());
      sheet.add({std::string(scene) + ".runs", scene, "it runs", error.what(), 0, NAN, NAN, 0});
    }
  }
  return sheet.finish(folder);
}

}  // namespace
}  // namespace verify::answers

int main(int argc, char** argv) { return reproduce::program_main(argc, argv, verify::answers::run); }
