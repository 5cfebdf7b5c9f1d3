#include "contensou/granular/colouring.hpp"

#include <bit>

namespace contensou {

int Colouring::next(std::uint32_t first, std::uint32_t second) {
  const bool alone = second >= used_.size();
  const std::uint64_t used = used_[first] | (alone ? 0 : used_[second]);
  const int colour = std::countr_one(used);
  if (colour == rest) return rest;
  const std::uint64_t bit = std::uint64_t{1} << static_cast<unsigned>(colour);
  used_[first] |= bit;
  if (!alone) used_[second] |= bit;
  return colour;
}

}  // namespace contensou
