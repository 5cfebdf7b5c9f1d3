#include "contensou/system/body_contacts.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "contensou/system/body_limits.hpp"

namespace contensou {
namespace {

struct Surface {
  BodySide side;
  std::size_t index;  ///< in BodiesData::rule
};

std::vector<Surface> surfaces(const BodiesData& data) {
  std::vector<Surface> all;
  for (std::size_t b = 0; b < data.bodies.size(); ++b) {
    const BodyData& body = data.bodies[b];
    for (std::size_t s = 0; s < body.spheres.size(); ++s) {
      const SphereData& sphere = body.spheres[s];
      all.push_back({{b, s, sphere.centre, sphere.radius, sphere.radius}, sphere.surface});
    }
    if (body.base)
      all.push_back({{b, {}, Eigen::Vector3d::Zero(), body.base->height, 0}, body.base->surface});
  }
  return all;
}

std::string title(const BodiesData& data, const BodySide& side) {
  const BodyData& body = data.bodies[side.body];
  return side.sphere ? body.spheres[*side.sphere].name : body.base->name;
}

[[noreturn]] void reject(const BodiesData& data, const BodyPair& pair, const std::string& expected) {
  const std::string with = pair.other ? title(data, *pair.other) : "plane " + data.planes[pair.plane].name;
  throw std::invalid_argument(title(data, pair.side) + " touches " + with + " by rule " +
                              data.rules[pair.rule].name + ", expected " + expected);
}

void require_valid(const BodiesData& data, const BodyPair& pair) {
  const bool base = !pair.side.sphere || (pair.other && !pair.other->sphere);
  if (base && pair.other) reject(data, pair, "a base to touch planes only");
  if (base) {
    const Eigen::Vector3d axis = data.bodies[pair.side.body].orientation * Eigen::Vector3d::UnitZ();
    if ((axis - data.planes[pair.plane].normal).norm() > unit_tolerance)
      reject(data, pair, "a plane across the third axis of the body");
  }
  const auto spins = [&](const BodySide& side) { return data.bodies[side.body].rotation != Rotation::none; };
  if (rows(data.rules[pair.rule].friction) > 3 && !spins(pair.side) && !(pair.other && spins(*pair.other)))
    reject(data, pair, "friction without drilling where no body can spin");
}

}  // namespace

std::vector<BodyPair> body_pairs(const BodiesData& data) {
  const std::vector<Surface> all = surfaces(data);
  std::vector<BodyPair> pairs;
  const auto add = [&](std::size_t a, std::size_t b, const BodyPair& pair) {
    const int rule = data.rule(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b));
    if (rule == BodiesData::no_rule) return;
    pairs.push_back(pair);
    pairs.back().rule = static_cast<std::size_t>(rule);
    require_valid(data, pairs.back());
  };
  for (const Surface& surface : all) {
    for (std::size_t p = 0; p < data.planes.size(); ++p)
      add(surface.index, data.planes[p].surface, {0, surface.side, {}, p});
  }
  for (std::size_t j = 0; j < all.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      if (all[i].side.body != all[j].side.body)
        add(all[i].index, all[j].index, {0, all[j].side, all[i].side, 0});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const BodyPair& a, const BodyPair& b) { return a.rule < b.rule; });
  return pairs;
}

std::vector<SystemContact> pair_contacts(const BodiesData& data, const std::vector<BodyPair>& pairs) {
  std::vector<std::size_t> of_rule(data.rules.size(), 0), named(data.rules.size(), 0);
  for (const BodyPair& pair : pairs) ++of_rule[pair.rule];
  std::vector<SystemContact> contacts;
  for (const BodyPair& pair : pairs) {
    SystemContact contact = data.rules[pair.rule];
    if (of_rule[pair.rule] > 1) contact.name.append("_").append(std::to_string(++named[pair.rule]));
    if (follows_load(contact)) {
      if (!pair.side.sphere) reject(data, pair, "a contact radius that does not follow the load");
      const double r = pair.side.reach;
      contact.load_radius->relative_radius = pair.other ? r * pair.other->reach / (r + pair.other->reach) : r;
    }
    contacts.push_back(contact);
  }
  return contacts;
}

}  // namespace contensou
