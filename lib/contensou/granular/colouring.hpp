#pragma once

#include <cstdint>
#include <vector>

namespace contensou {

/// Gives contacts colours, so that no body has two contacts of one colour: those of one colour can be solved
/// at the same time, in any order, with the same result to the last bit. First fit, in the order of the
/// contacts. A body with very many contacts runs out of colours: what is left over gets the last one, `rest`,
/// which has to be solved one by one.
class Colouring {
 public:
  static constexpr int rest = 64;

  /// For `bodies` bodies, none of which has a contact yet.
  void clear(std::size_t bodies) { used_.assign(bodies, 0); }
  /// The colour of the next contact, between two bodies or, second >= bodies, a body and what stands still,
  /// 0 to rest.
  int next(std::uint32_t first, std::uint32_t second);

 private:
  std::vector<std::uint64_t> used_;  ///< colours of a body, a bit each
};

}  // namespace contensou
