#include "contensou/scene/read_loads.hpp"

#include <algorithm>

namespace contensou {
namespace {

CourseData read_course(SceneReader& read, const std::string& table) {
  CourseData course;
  const std::string times = table + "times";
  const std::string factors = table + "factors";
  if (read.has(times) || read.has(factors)) {
    course.times = read.numbers(times, {.expected = "an array of increasing times [s]"});
    course.factors = read.numbers(factors, {.expected = "an array of numbers, as many as times"});
    if (std::adjacent_find(course.times.begin(), course.times.end(), std::greater_equal<>()) !=
        course.times.end())
      read.refuse(times, "does not increase", "an array of increasing times [s]");
    if (read.has(times) && read.has(factors) && course.times.size() != course.factors.size())
      read.refuse(factors, "has " + std::to_string(course.factors.size()) + " entries",
                  std::to_string(course.times.size()) + ", as in times");
  }
  const auto frequency = read.optional_number(table + "frequency", not_negative);
  course.frequency = frequency.value_or(0);
  if (frequency) {
    course.phase = read.optional_number(table + "phase", Range{}).value_or(0);
  } else {
    read.unused(table + "phase", "a load without frequency");
  }
  return course;
}

}  // namespace

LoadData read_load(SceneReader& read, const std::string& name) {
  const std::string table = "load." + name + '.';
  LoadData load;
  load.name = name;
  load.force = read.optional_vector(table + "force").value_or(Eigen::Vector3d::Zero());
  load.torque = read.optional_vector(table + "torque").value_or(Eigen::Vector3d::Zero());
  if (!read.has(table + "force") && !read.has(table + "torque")) read.vector(table + "force");  // missing
  load.course = read_course(read, table);
  return load;
}

void resolve_load(const SceneReader& read, const std::vector<BodyData>& bodies, const std::string& body,
                  LoadData& load) {
  const std::string table = "load." + load.name + '.';
  const auto found =
      std::find_if(bodies.begin(), bodies.end(), [&](const BodyData& b) { return b.name == body; });
  if (found == bodies.end())
    read.refuse(table + "body", "is not in the scene", "the name of a body, or BALLS.1 and so on");
  load.body = static_cast<std::size_t>(found - bodies.begin());
  const bool turns = found->rotation == Rotation::free || found->rotation == Rotation::upright;
  if (read.has(table + "torque") && !turns)
    read.refuse(table + "torque", "cannot turn " + body, "no such key, or a body that is free or upright");
}

}  // namespace contensou
