#include "contensou/scene/between.hpp"

#include <numeric>
#include <set>

#include "contensou/scene/unit_length.hpp"
#include "contensou/text/quoted.hpp"

namespace contensou {
namespace {

using Kind = Surface::Kind;

/// Enters the pairs of one contact.
class RuleWriter {
 public:
  RuleWriter(const SceneReader& read, const std::vector<Surface>& surfaces, BodiesScene& scene,
             std::size_t contact)
      : read_(read),
        surfaces_(surfaces),
        scene_(scene),
        contact_(scene.contacts[contact]),
        index_(static_cast<int>(contact)),
        key_("contact." + contact_.name + ".between") {}

  void write(const std::vector<std::string>& names) {
    if (names.size() != 2) return;  // missing, and reported
    const std::vector<std::size_t> first = find(names[0]);
    const std::vector<std::size_t> second = find(names[1]);
    bool any = false;
    for (const std::size_t a : first) {
      for (const std::size_t b : second) any = write(a, b) || any;
    }
    if (!any)
      read_.refuse(key_, "names nothing that can touch",
                   "bodies or balls, and planes or other bodies; spheres of one body do not touch");
  }

 private:
  std::vector<std::size_t> find(const std::string& name) const {
    std::vector<std::size_t> found = named(surfaces_, name);
    if (found.empty())
      read_.refuse(key_, "names " + in_quotes(name) + ", which is no surface",
                   "two of " + owners(surfaces_) + ", or of their surfaces");
    return found;
  }

  bool spins(const Surface& surface) const {
    return surface.is_of_bodies() && scene_.data.bodies[surface.first].rotation != Rotation::none;
  }

  [[noreturn]] void refuse(const Surface& a, const Surface& b, const std::string& what,
                           const std::string& expected) const {
    read_.refuse(key_, "holds " + a.name + " and " + b.name + what, expected);
  }

  void require_base(const Surface& base, const Surface& other) const {
    if (other.is_of_bodies()) refuse(base, other, ": a base touches planes only", "a sphere's name instead");
    const Eigen::Vector3d axis = scene_.data.bodies[base.first].orientation * Eigen::Vector3d::UnitZ();
    if ((axis - scene_.data.planes[other.first].normal).norm() > unit_tolerance)
      refuse(base, other, ": the plane is not across the axis of the base",
             "planes whose normal is the body's third axis");
    if (contact_.modulus)
      refuse(base, other, ": a base has no radius by Hertz", "a radius in metres, or a sphere's name");
  }

  /// Whether the two can touch at all; refuses what they cannot do.
  bool write(std::size_t i, std::size_t j) {
    const Surface& a = surfaces_[i];
    const Surface& b = surfaces_[j];
    if (!a.is_of_bodies() && !b.is_of_bodies()) return false;
    const bool same_body = a.is_of_bodies() && b.is_of_bodies() && a.first == b.first;
    if (same_body && a.kind != Kind::balls) return false;
    if (a.kind == Kind::base) require_base(a, b);
    if (b.kind == Kind::base) require_base(b, a);
    if (contact_.rows() == 4 && !spins(a) && !spins(b))
      refuse(a, b, ": there is no drilling friction where nothing can turn", "law = \"coulomb\"");
    int& rule = scene_.data.rule(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    if (rule != BodiesData::no_rule && rule != index_)
      refuse(a, b, ", as does contact " + scene_.contacts[static_cast<std::size_t>(rule)].name,
             "one contact for each pair");
    rule = index_;
    scene_.data.rule(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) = index_;
    return true;
  }

  const SceneReader& read_;
  const std::vector<Surface>& surfaces_;
  BodiesScene& scene_;
  const ContactScene& contact_;
  int index_;
  std::string key_;
};

void require_distinct_names(const SceneReader& read, const BodiesScene& scene) {
  std::set<std::string> names;
  for (const PairName& pair : pair_names(scene)) {
    if (!names.insert(pair.name).second)
      read.refuse_table("contact." + scene.contacts[pair.rule].name,
                        "makes a second contact named " + pair.name + " (pairs of a contact are numbered)",
                        "another name");
  }
}

}  // namespace

void resolve_rules(const SceneReader& read, const std::vector<Surface>& surfaces,
                   const std::vector<std::vector<std::string>>& between, Method method, BodiesScene& scene) {
  const auto size = static_cast<Eigen::Index>(surfaces.size());
  scene.data.rule.setConstant(size, size, BodiesData::no_rule);
  for (std::size_t i = 0; i < between.size(); ++i) RuleWriter(read, surfaces, scene, i).write(between[i]);
  if (method == Method::nscd) return;
  const std::vector<std::size_t> counts = count_pairs(scene.data, scene.contacts.size());
  const std::size_t pairs = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  if (pairs > most_pairs)
    read.refuse("integrator.method", "would watch all of " + std::to_string(pairs) + " pairs",
                "at most " + std::to_string(most_pairs) + ", or method nscd");
  require_distinct_names(read, scene);
}

std::vector<PairName> pair_names(const BodiesScene& scene) {
  std::vector<PairName> names;
  const std::vector<std::size_t> counts = count_pairs(scene.data, scene.contacts.size());
  for (std::size_t rule = 0; rule < counts.size(); ++rule) {
    const std::string& name = scene.contacts[rule].name;
    for (std::size_t k = 1; k <= counts[rule]; ++k)
      names.push_back({counts[rule] == 1 ? name : name + '_' + std::to_string(k), rule});
  }
  return names;
}

}  // namespace contensou
