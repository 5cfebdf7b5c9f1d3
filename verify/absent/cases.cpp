#include "cases.hpp"

namespace verify::absent {
namespace {

std::string head(const std::string& method, const std::string& scene,
                 const std::string& output = "columns = [\"energy\"]\n") {
  return "[scene]\nsystem = \"bodies\"\nduration = 1\n" + scene + "[integrator]\nmethod = \"" + method +
         "\"\nstep = 1e-3\ntolerance = 1e-9\nsolver_tolerance = 1e-9\n[output]\n" + output;
}

std::string body(const std::string& name, double y) {
  return "[body." + name +
         "]\nrotation = \"free\"\nmass = 0.2\ninertia = 5e-5\nvelocity = [1, 0, 0]\nspin = [3, 5, 200]\n" +
         "position = [0, " + std::to_string(y) + ", 0.025]\n[body." + name +
         ".sphere.hull]\nradius = 0.025\n";
}

std::string contact(const std::string& name, const std::string& law) {
  return "[contact." + name + "]\nbetween = [\"" + name + "\", \"table\"]\n" + law;
}

/// [s]; from event to event steps are long, and longer where nothing touches.
double duration(const std::string& method, bool touches) {
  if (method != "event_driven") return 0.03;
  return touches ? 0.1 : 3;
}

constexpr const char* gravity = "gravity = 9.81\n";
constexpr const char* table = "[plane.table]\nnormal = [0, 0, 1]\noffset = 0\n";
constexpr const char* frictionless = "law = \"frictionless\"\n";
constexpr const char* coulomb = "law = \"coulomb\"\nmu = 0.3\n";
constexpr const char* contensou = "law = \"contensou\"\npressure = \"hertz\"\nmu = 0.3\nradius = 1e-3\n";

std::string ball_on_table(const std::string& method, const std::string& law) {
  return head(method, gravity) + table + body("ball", 0) + contact("ball", law);
}

std::string free_body(const std::string& method, const std::string& output = "columns = [\"energy\"]\n") {
  return head(method, "", output) +
         "[body.book]\nrotation = \"free\"\nmass = 0.8\ninertia = [2e-3, 5.8e-3, 3.9e-3]\n"
         "position = [0, 0, 0]\nspin = [0.05, 0.02, 10]\n";
}

}  // namespace

CountedScene ball_with_patch(const std::string& method) {
  return {"contensou",
          method,
          "",
          ball_on_table(method, contensou),
          duration(method, true),
          {},
          {"contact", "friction", "ball", "law"}};
}

std::vector<CountedScene> counted_scenes() {
  std::vector<CountedScene> scenes;
  for (const char* method : {"moreau", "event_driven", "nscd"}) {
    const auto add = [&](const char* name, const char* effect, const std::string& text,
                         const std::vector<std::string>& absent, const std::vector<std::string>& present) {
      const bool touches = text.find("[contact") != std::string::npos;
      scenes.push_back({name, method, effect, text, duration(method, touches), absent, present});
    };
    add("free_body", "contact", free_body(method), {"contact", "friction", "ball", "law", "arcs"}, {});
    add("frictionless", "friction", ball_on_table(method, frictionless), {"friction", "ball", "law", "arcs"},
        {"contact"});
    add("coulomb", "drilling friction", ball_on_table(method, coulomb), {"ball", "law", "arcs"},
        {"contact", "friction"});
    scenes.push_back(ball_with_patch(method));
  }
  // No law needs an inverse trigonometric function while it runs; a tilt that is told does.
  scenes.push_back({"free_body_told",
                    "moreau",
                    "",
                    free_body("moreau", "columns = [\"book.tilt\"]\ninterval = 1e-3\n"),
                    0.03,
                    {"contact", "friction", "ball", "law"},
                    {"arcs"}});
  return scenes;
}

CountedScene balls_on_table(const std::string& method, int balls, int contensou_balls) {
  std::string text = head(method, gravity) + table;
  for (int i = 0; i < balls; ++i) {
    const std::string name = "ball" + std::to_string(i + 1);
    text += body(name, 0.1 * i) + contact(name, i < contensou_balls ? contensou : coulomb);
  }
  return {std::to_string(contensou_balls) + "_of_" + std::to_string(balls) + "_contensou",
          method,
          contensou_balls < balls ? "drilling friction of the others" : "",
          text,
          0.01,
          {},
          {"ball", "law"}};
}

}  // namespace verify::absent
