#include "contensou/granular/nscd_step.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "contensou/granular/fidelity.hpp"
#include "contensou/text/number.hpp"

namespace contensou {
namespace {

constexpr int most_sweeps = 1000;
/// Of contacts that close by the impulses of others: each round lets an impact go one contact farther.
constexpr int most_rounds = 10;
/// How near counts as touching, in parts of the smallest radius: what rests is not left out by rounding.
constexpr double touching = 1e-3;
/// What a start may penetrate, in parts of a radius: the rounding of who placed the bodies; beside what a
/// step leaves to the next one, some ½Δt²g.
constexpr double penetration_limit = 1e-6;

}  // namespace

NscdStep::NscdStep(const BodyLayout& layout, const IntegratorOptions& options, WorkerTeam& team,
                   RunReport& report, NscdCounts& counts)
    : layout_(layout),
      fidelity_(options.fidelity),
      report_(report),
      counts_(counts),
      motion_(layout),
      list_(layout.data()),
      set_(layout.data()),
      solver_(options.solver_tolerance, most_sweeps, team),
      room_(layout.bodies()),
      reach_(layout.bodies()),
      touch_(layout.bodies(), BodyMotion::Touch::untouched),
      excess_(layout.bodies()) {
  report_.dissipated.resize(layout.data().rules.size());
  report_.work.resize(motion_.works());
  for (std::size_t i = 0; i < room_.size(); ++i) {
    const double radius = motion_.smallest_radius(i);
    room_[i] = std::isfinite(radius) ? touching * radius : 0;
  }
}

void NscdStep::require_apart(const State& state, double dt) {
  if (!list_.any_rules()) return;
  motion_.begin(state, 0);
  reach_ = room_;
  look(state);
  const double left = dt * dt * layout_.data().gravity.norm();
  for (std::size_t k = 0; k < approach_.size(); ++k) {
    const NearPair& pair = list_.pairs()[k];
    const Shape& first = list_.shapes()[pair.first];
    if (approach_[k].gap >= -penetration_limit * first.radius - left) continue;
    throw std::invalid_argument(list_.describe(pair) + ": gap " + to_text(approach_[k].gap) +
                                " m at the start, expected one that is not negative");
  }
}

void NscdStep::advance(State& state, double dt) {
  motion_.begin(state, dt);
  after_ = motion_.free();
  if (list_.any_rules()) solve_contacts(state, dt);
  motion_.end(after_, touch_, state, excess_, report_.work);
  if (!list_.any_rules()) return;
  add_dissipation(layout_.data(), set_, approach_, motion_.before(), after_, excess_, load_,
                  report_.dissipated);
  for (std::size_t i = 0; i < layout_.bodies(); ++i) list_.moved(i, reach_[i] - room_[i]);
}

/// The largest way of any point of a body in the step, with the velocities before and these.
void NscdStep::update_reach(const std::vector<Twist>& twists, double dt) {
  for (std::size_t i = 0; i < reach_.size(); ++i) {
    const Twist& a = motion_.before()[i];
    const double v = std::max(a.v.norm(), twists[i].v.norm());
    const double spin = std::max(a.omega.norm(), twists[i].omega.norm());
    reach_[i] = std::max(reach_[i], room_[i] + dt * (v + motion_.extent(i) * spin));
  }
}

/// Makes the list anew if it has to be; returns whether it did, and looked at it.
bool NscdStep::look(const State& state) {
  if (!list_.update(layout_, state, reach_)) return false;
  ++counts_.lists;
  look_again();
  return true;
}

void NscdStep::look_again() {
  look_at(list_, motion_, approach_);
  counts_.pairs_examined += static_cast<std::int64_t>(approach_.size());
}

/// Chooses pairs that close with these velocities, or nearly: `rooms` times the room. Returns whether any
/// were not chosen before.
bool NscdStep::choose(const std::vector<Twist>& twists, double rooms, double dt) {
  bool more = false;
  for (std::size_t k = 0; k < approach_.size(); ++k) {
    NearPair& pair = list_.pairs()[k];
    if (pair.chosen) continue;
    const Approach& a = approach_[k];
    const auto [first, second] = list_.bodies(pair);
    const double room = rooms * (room_[first] + (second < room_.size() ? room_[second] : 0));
    if (!(a.gap + dt * a.velocity(twists[first], twists[second]) < room)) continue;
    pair.chosen = true;
    more = true;
  }
  return more;
}

/// Chosen contacts with drilling friction and a constant radius that may be solved as point contacts, by the
/// velocities before the step.
void NscdStep::choose_points() {
  for (std::size_t k = 0; k < approach_.size(); ++k) {
    NearPair& pair = list_.pairs()[k];
    const SystemContact& rule = layout_.data().rules[pair.rule];
    if (!pair.chosen || rule.load_radius || rows(rule.friction) < 4) continue;
    const Approach& a = approach_[k];
    const auto [i, j] = list_.bodies(pair);
    const Twist& first = motion_.before()[i];
    const Twist& second = motion_.before()[j];
    const Eigen::Vector3d velocity =
        first.v - second.v + first.omega.cross(a.arm) - second.omega.cross(a.other);
    const double v = (velocity - a.normal.dot(velocity) * a.normal).norm();
    const double s = rule.radius * std::abs(a.normal.dot(first.omega - second.omega));
    pair.exact = !(point_error(rule.friction, v, s) <= *fidelity_);
  }
}

/// Solves for the impulses of all contacts: after_, touch_ and set_.
void NscdStep::solve_contacts(const State& state, double dt) {
  std::fill(reach_.begin(), reach_.end(), 0.0);
  update_reach(after_, dt);
  if (!look(state)) look_again();
  for (NearPair& pair : list_.pairs()) {
    pair.chosen = false;
    pair.exact = true;
  }
  for (const Approach& a : approach_) counts_.deepest = std::max(counts_.deepest, -a.gap);
  bool more = choose(after_, 1, dt);
  if (fidelity_) choose_points();
  set_.clear();
  BlockReport solved;
  for (int round = 1; more; ++round) {
    set_.build(list_, approach_, motion_.mobility(), dt);
    after_ = motion_.free();
    solved = solver_.solve(set_, motion_.mobility(), after_);
    set_.store(list_);
    report_.contact_iterations += solved.sweeps;
    if (round == most_rounds) break;
    const bool refused = fidelity_ && refuse_points(layout_.data(), set_, after_, *fidelity_, list_);
    update_reach(after_, dt);
    const bool anew = look(state);  // what the set knows of its pairs is of the old list
    more = choose(after_, 0, dt) || anew || refused;
  }
  decide_touch(set_, approach_, motion_.before(), after_, dt, touch_);
  if (set_.size() == 0) return;
  ++report_.contact_problems;
  if (fidelity_) add_left_out(layout_.data(), set_, motion_.before(), after_, report_.left_out);
  report_.worst_residual = std::max(report_.worst_residual, solved.residual);
  if (!solved.solved || more) ++counts_.unsolved;
  counts_.contacts += static_cast<std::int64_t>(set_.size());
  counts_.most_contacts = std::max(counts_.most_contacts, set_.size());
}

}  // namespace contensou
