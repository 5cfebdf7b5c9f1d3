#pragma once

#include <cstdint>
#include <span>
#include <tuple>
#include <variant>
#include <vector>

#include "contensou/granular/approach.hpp"
#include "contensou/granular/colouring.hpp"
#include "contensou/granular/contact_block.hpp"
#include "contensou/granular/pair_list.hpp"

namespace contensou {

/// The contacts of one step, in the order in which they are solved: colour after colour, in each rule after
/// rule. Contacts of one colour and one rule are a run: one kind of friction, known to the compiler.
class ContactSet {
 public:
  struct Run {
    const AnyFriction* friction;
    double mu;
    std::uint32_t rule;
    int colour;
    bool as_point;             ///< drilling friction left out
    std::size_t first, count;  ///< in the blocks of its number of rows
  };

  /// The data outlive it.
  explicit ContactSet(const BodiesData& data) : data_(data) {}

  /// The set of the chosen pairs of the list, with the impulses they have to start from. Those with drilling
  /// friction that are not `exact` are solved as point contacts.
  void build(const PairList& list, const std::vector<Approach>& approach,
             const std::vector<Mobility>& mobility, double dt);
  void clear();
  /// Writes impulses back to the pairs they are of, zero to others.
  void store(PairList& list);

  std::size_t size() const { return order_.size(); }
  const std::vector<Run>& runs() const { return runs_; }
  Eigen::Index rows() const { return rows_; }               ///< of all contacts
  std::size_t largest_run() const { return largest_run_; }  ///< contacts

  /// Calls function(domain, run, blocks) for each run in order, `blocks` a span of ContactBlock<rows>. The
  /// kind of friction is looked up here, once for each run.
  template <class Function>
  void for_each_run(Function&& function) {
    for (const Run& run : runs_) {
      std::visit(
          [&]<class Domain>(const Domain& domain) {
            auto& blocks = std::get<std::vector<ContactBlock<1 + Domain::dimension>>>(blocks_);
            function(domain, run, std::span(blocks).subspan(run.first, run.count));
          },
          *run.friction);
    }
  }

 private:
  struct Order {
    int colour;
    std::uint32_t rule;
    bool as_point;
    std::uint32_t pair;
  };

  void sort(const PairList& list);

  const BodiesData& data_;
  AnyFriction point_ = FrictionDisk{};
  Eigen::Index rows_ = 0;
  std::size_t largest_run_ = 0;
  Colouring colouring_;
  std::vector<Order> order_;
  std::vector<Run> runs_;
  std::tuple<std::vector<ContactBlock<1>>, std::vector<ContactBlock<3>>, std::vector<ContactBlock<4>>>
      blocks_;
};

}  // namespace contensou
