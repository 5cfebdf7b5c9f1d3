#include <algorithm>
#include <cmath>
#include <string>

#include "checks.hpp"
#include "contensou/output/table.hpp"
#include "pile.hpp"
#include "shipped.hpp"

namespace verify::answers {

void check_pile(Sheet& sheet) {
  const std::string file = "pile", by = "no closed form";
  const Shipped run(file);
  const auto& books = run.outcome().energy;
  const double fallen = books.initial - books.final;
  sheet.compare({"pile.rest", file, "kinetic energy in the end, in what gravity gave", "it comes to rest", 0,
                 run.measured("kinetic") / fallen, 0, pile::rest});
  sheet.compare({"pile.outside", file, "deepest centre of a marble beyond the glass less its radius [m]",
                 "0, all of them", 0, std::max(0.0, pile::deepest(run)), 0, pile::depth});
  sheet.compare({"pile.energy", file, "imbalance of the energy's books, in what gravity gave",
                 "E_0 = E_1 + dissipated", 0, books.imbalance() / fallen, 0, pile::books});
  const pile::Spread spread = pile::reference();
  for (const char* name : {"potential", "height"}) {
    const pile::Statistic& s = spread.at(name);
    sheet.compare(
        {std::string("pile.") + name, file,
         std::string(name) + " in the end, distance from the mean over seeds in standard deviations",
         "reference_data/scenes/pile.tsv", 0, (run.measured(name) - s.mean) / s.deviation, 0,
         pile::most_deviations});
  }
  const Shipped threads(file, {"integrator.threads=2"});
  sheet.compare({"pile.threads", file, "two threads: largest change of the state in the end", "none", 0,
                 (threads.end().q - run.end().q).cwiseAbs().maxCoeff(), 0, 0});
}

}  // namespace verify::answers
