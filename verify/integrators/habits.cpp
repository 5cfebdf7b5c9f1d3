#include "checks.hpp"
namespace verify::integrators {
void check_habits(const std::filesystem::path&, Record&, Findings&) {}
}
