#include "checks.hpp"
namespace verify::integrators {
void judge_sentences(Record&, const Findings&) {}
}
