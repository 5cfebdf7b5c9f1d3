#include "contensou/scene/read_measures.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "contensou/scene/between.hpp"
#include "contensou/scene/columns.hpp"
#include "contensou/text/quoted.hpp"

namespace contensou {
namespace {

using Kind = MeasureScene::Kind;

bool is_of_event(Kind kind) { return kind == Kind::event || kind == Kind::count; }

Kind kind_named(const std::string& text) {
  for (const Kind kind :
       {Kind::final, Kind::minimum, Kind::maximum, Kind::crossing, Kind::event, Kind::count})
    if (text == name(kind)) return kind;
  return Kind::trajectory;
}

MeasureScene read_measure(SceneReader& read, const std::string& title) {
  const std::string table = "outcome." + title + '.';
  MeasureScene measure;
  measure.name = title;
  const std::string kind = read.choice(
      table + "kind", {"final", "minimum", "maximum", "crossing", "trajectory", "event", "count"});
  measure.kind = kind_named(kind);
  const auto unused = [&](std::initializer_list<const char*> keys) {
    for (const char* key : keys) read.unused(table + key, "kind " + kind);
  };
  if (is_of_event(measure.kind)) {
    unused({"column", "value"});
    measure.event = read.choice(table + "event", {"close", "open", "accumulation", "stick", "slip", "spin"});
    measure.contact = read.text(table + "contact", "the name of a contact");
  } else {
    unused({"event", "contact"});
    measure.column = read.text(table + "column", "a column of the trajectory");
  }
  if (measure.kind == Kind::crossing) {
    measure.value = read.number(table + "value", Range{});
  } else if (!is_of_event(measure.kind)) {
    unused({"value"});
  }
  if (measure.kind == Kind::event) {
    measure.occurrence =
        read.optional_whole(table + "occurrence", 1, std::numeric_limits<int>::max()).value_or(1);
  } else {
    unused({"occurrence"});
  }
  return measure;
}

/// The contacts that events tell of.
std::vector<std::string> contacts_of_events(const Scene& scene) {
  std::vector<std::string> names;
  if (const auto* bodies = std::get_if<BodiesScene>(&scene.system)) {
    for (PairName& pair : pair_names(*bodies)) names.push_back(std::move(pair.name));
  } else {
    for (const ContactScene* contact : scene.contacts()) names.push_back(contact->name);
  }
  return names;
}

std::string one_of(const std::vector<std::string>& names) {
  if (names.empty()) return "none: nothing touches";
  constexpr std::size_t longest = 100;  // of a line that still helps
  std::string list = "one of";
  for (const std::string& name : names) {
    if (list.size() > longest) return list + " and others";
    list += ' ' + name;
  }
  return list;
}

}  // namespace

void read_measures(SceneReader& read, Scene& scene) {
  scene.columns = read.optional_texts("output.columns", {.expected = "an array of names of columns"})
                      .value_or(std::vector<std::string>());
  for (const std::string& name : read.tables("outcome")) scene.measures.push_back(read_measure(read, name));
}

void require_measurable(const SceneReader& read, const Scene& scene) {
  std::vector<std::string> seen;
  for (const std::string& column : scene.columns) {
    if (!has_column(scene, column))
      read.refuse("output.columns", "names " + in_quotes(column) + ", which is no column here",
                  column_help(scene));
    if (std::find(seen.begin(), seen.end(), column) != seen.end())
      read.refuse("output.columns", "names " + in_quotes(column) + " twice", "each column once");
    seen.push_back(column);
  }
  const double numbers =
      scene.duration / scene.integrator.output_interval * static_cast<double>(columns(scene).size());
  if (numbers > most_numbers)
    read.refuse("output.interval", "makes more than 1e8 numbers", "a longer interval, or fewer columns");
  const bool nscd = scene.integrator.method == Method::nscd;
  for (const MeasureScene& measure : scene.measures) {
    const std::string table = "outcome." + measure.name + '.';
    if (!is_of_event(measure.kind)) {
      if (!has_column(scene, measure.column))
        read.refuse(table + "column", "is no column here", column_help(scene));
      continue;
    }
    if (nscd) read.refuse(table + "kind", "is not for method nscd, which has no events", "another kind");
    const std::vector<std::string> contacts = contacts_of_events(scene);
    if (std::find(contacts.begin(), contacts.end(), measure.contact) == contacts.end())
      read.refuse(table + "contact", "is no contact here", one_of(contacts));
  }
}

}  // namespace contensou
