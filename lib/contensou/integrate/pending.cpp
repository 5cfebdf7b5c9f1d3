// Schemes that are not written yet; each goes from here as it comes.
#include <stdexcept>

#include "contensou/integrate/schemes.hpp"

namespace contensou {

#define PENDING(run)                                                                                    \
  RunReport run(const MechanicalSystem&, State&, double, const IntegratorOptions&, const Observer&) {   \
    throw std::logic_error(#run ": not written yet");                                                   \
  }
PENDING(run_moreau_adaptive)
#undef PENDING

}  // namespace contensou
