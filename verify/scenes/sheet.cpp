#include "sheet.hpp"

#include <cmath>

namespace verify::answers {

Sheet::Sheet()
    : record_("scenes"),
      table_{{"The scenes that ship: what their runs give beside the answer. SI units, radians; error and "
              "bound in the "
              "unit of the answer unless the question says otherwise."},
             {"scene", "question", "answer", "expected", "obtained", "error", "bound"},
             {}} {}

void Sheet::add(const Answer& a) {
  table_.add({a.scene, a.question, a.source, a.expected, a.obtained, a.error, a.bound});
  record_.add(Claim{"scenes." + a.id, "scenes/" + a.scene + ".toml", a.question + "; " + a.source, a.expected,
                    a.obtained, a.error, a.bound, true});
}

void Sheet::compare(Answer answer) {
  answer.error = std::abs(answer.obtained - answer.expected);
  add(answer);
}

int Sheet::finish(const std::filesystem::path& folder) const {
  contensou::write_table(table_, folder / "scenes.tsv");
  return record_.finish(folder / "parts");
}

}  // namespace verify::answers
