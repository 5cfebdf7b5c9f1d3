#include "checks.hpp"
namespace verify::integrators {

}
