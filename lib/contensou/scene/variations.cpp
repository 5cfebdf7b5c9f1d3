#include "contensou/scene/variations.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>
#include <utility>

#include "contensou/scene/columns.hpp"
#include "contensou/scene/read_contact.hpp"
#include "contensou/scene/variation_edit.hpp"
#include "contensou/scene/weight_radius.hpp"
#include "contensou/text/number.hpp"

namespace contensou {
namespace {

using Edit = VariationEdit;
using Contacts = std::vector<const ContactScene*>;

/// Methods other than the scene's own have steps and tolerances of their own, where the scene has none.
constexpr double default_steps = 1e4;  ///< of the whole run
constexpr double default_tolerance = 1e-9;

bool has_drilling(const ContactScene& contact) { return contact.rows() == 4; }
bool has_friction(const ContactScene& contact) { return contact.rows() >= 3; }

class Generator {
 public:
  Generator(const SceneDocument& document, const Scene& scene)
      : document_(document), scene_(scene), contacts_(scene.contacts()) {
    if (document_.values.contains("output.columns")) unset_value(document_, "output.columns");
    if (!tables_below(document_, "outcome").empty()) unset_value(document_, "outcome");
  }

  std::vector<Variation> all() {
    take(Edit(document_, "scene", "as it is"));
    friction();
    pressure();
    radius();
    restitution();
    world();
    accuracy();
    return std::move(variations_);
  }

 private:
  using Change = std::function<void(Edit&, const std::string& table)>;
  using Wanted = std::function<bool(const ContactScene&)>;

  void take(Edit edit) { variations_.push_back(std::move(edit.variation)); }

  Variation on(const Contacts& contacts, const char* effect, const std::string& change, const Change& make) {
    Edit edit(document_, effect, change);
    for (const ContactScene* contact : contacts) {
      make(edit, "contact." + contact->name + '.');
      edit.variation.contacts += (edit.variation.contacts.empty() ? "" : ", ") + contact->name;
    }
    return std::move(edit.variation);
  }

  /// All wanted contacts at once, and each alone.
  std::vector<Variation> each(const Wanted& wanted, const char* effect, const std::string& change,
                              const Change& make) {
    Contacts these;
    std::copy_if(contacts_.begin(), contacts_.end(), std::back_inserter(these),
                 [&](const ContactScene* contact) { return wanted(*contact); });
    std::vector<Variation> made;
    if (!these.empty()) made.push_back(on(these, effect, change, make));
    if (these.size() > 1) {
      for (const ContactScene* contact : these) made.push_back(on({contact}, effect, change, make));
    }
    return made;
  }

  void add(const Wanted& wanted, const char* effect, const std::string& change, const Change& make) {
    for (Variation& variation : each(wanted, effect, change, make))
      variations_.push_back(std::move(variation));
  }

  void friction() {
    const auto other = [](const char* model) {
      return [model](const ContactScene& contact) { return has_drilling(contact) && contact.model != model; };
    };
    add(other("exact"), "friction", "exact", make_exact);
    add(other("ellipsoid"), "friction", "ellipsoid", make_ellipsoid);
    uncoupled(each(other("uncoupled"), "friction", "uncoupled", make_uncoupled));
    add(has_drilling, "friction", "coulomb", make_coulomb);
    add(has_friction, "friction", "frictionless", make_frictionless);
  }

  /// The methods that follow smooth phases have no way with it: there both sides are run by time-stepping.
  void uncoupled(std::vector<Variation> made) {
    const bool by_steps = is_time_stepping(scene_.integrator.method);
    if (made.empty()) return;
    if (!by_steps) {
      method_at_ = variations_.size();
      variations_.push_back(with_method(document_, Method::moreau));
    }
    for (Variation& variation : made) {
      if (!by_steps) {
        Variation moved = with_method(variation.document, Method::moreau);
        variation.document = std::move(moved.document);
        variation.options.insert(variation.options.end(), moved.options.begin(), moved.options.end());
        variation.against = *method_at_;
      }
      variations_.push_back(std::move(variation));
    }
  }

  void pressure() {
    for (const char* pressure : {"hertz", "uniform"}) {
      add([&](const ContactScene& contact) { return has_drilling(contact) && contact.pressure != pressure; },
          "pressure", pressure,
          [&](Edit& edit, const std::string& table) { make_pressure(edit, table, pressure); });
    }
  }

  void radius() {
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const std::optional<double> constant = radius_under_weight(scene_, i);
      if (!constant) continue;
      variations_.push_back(
          on({contacts_[i]}, "radius", "constant", [&](Edit& edit, const std::string& table) {
            edit.unset(table + "modulus");
            edit.set(table + "radius", to_text(*constant));
          }));
    }
  }

  void restitution() {
    add([](const ContactScene& contact) { return contact.restitution > 0; }, "restitution", "off",
        [](Edit& edit, const std::string& table) { edit.unset(table + "restitution"); });
  }

  void world() {
    const bool top = std::holds_alternative<TippeTopScene>(scene_.system);
    if (top ? std::get<TippeTopScene>(scene_.system).data.g > 0
            : !std::get<BodiesScene>(scene_.system).data.gravity.isZero(0)) {
      Edit edit(document_, "gravity", "off");
      top ? edit.set("scene.gravity", "0") : edit.unset("scene.gravity");
      take(std::move(edit));
    }
    Edit drag(document_, "drag", "off");
    for (const char* table : {"body", "balls"}) {
      for (const std::string& body : tables_below(document_, table)) {
        drag.unset(body + ".linear_drag");
        drag.unset(body + ".angular_drag");
      }
    }
    if (!drag.variation.options.empty()) take(std::move(drag));
    loads();
    if (scene_.fidelity) {
      Edit edit(document_, "fidelity", "off");
      edit.unset("scene.fidelity");
      take(std::move(edit));
    }
  }

  void loads() {
    const std::set<std::string> loads = tables_below(document_, "load");
    if (loads.empty()) return;
    Edit all(document_, "loads", "off");
    all.unset("load");
    take(std::move(all));
    if (loads.size() < 2) return;
    for (const std::string& load : loads) {
      Edit one(document_, load, "off");
      one.unset(load);
      take(std::move(one));
    }
  }

  void accuracy() {
    const IntegratorOptions& options = scene_.integrator;
    if (has_fixed_step(options.method)) {
      for (const int times : {2, 10}) {
        Edit edit(document_, "integrator", std::to_string(times) + " times the step");
        edit.set("integrator.step", to_text(times * options.step));
        take(std::move(edit));
      }
    } else {
      Edit edit(document_, "integrator", "100 times the tolerance");
      edit.set("integrator.tolerance", to_text(100 * options.tolerance));
      take(std::move(edit));
    }
    if (method_at_) return;  // compared already
    variations_.push_back(
        with_method(document_, options.method == Method::event_driven || options.method == Method::nscd
                                   ? Method::moreau
                                   : Method::event_driven));
  }

  Variation with_method(const SceneDocument& document, Method method) const {
    Edit edit(document, "method", name(method));
    edit.set("integrator.method", name(method));
    for (const char* key : {"integrator.r", "integrator.threads"}) edit.unset(key);
    if (!is_time_stepping(method)) edit.unset("scene.fidelity");
    const char* setting = has_fixed_step(method) ? "integrator.step" : "integrator.tolerance";
    if (!document.values.contains(setting)) {
      edit.set(setting,
               to_text(has_fixed_step(method) ? scene_.duration / default_steps : default_tolerance));
    }
    return std::move(edit.variation);
  }

  SceneDocument document_;
  const Scene& scene_;
  Contacts contacts_;
  std::vector<Variation> variations_;
  std::optional<std::size_t> method_at_;
};

}  // namespace

std::vector<Variation> variations(const SceneDocument& document, const Scene& scene) {
  return Generator(document, scene).all();
}

Scene read_variation(const Variation& variation, const Scene& scene) {
  Scene read = read_scene(variation.document);
  std::copy_if(scene.columns.begin(), scene.columns.end(), std::back_inserter(read.columns),
               [&](const std::string& column) { return has_column(read, column); });
  std::copy_if(scene.measures.begin(), scene.measures.end(), std::back_inserter(read.measures),
               [&](const MeasureScene& measure) {
                 return measure.column.empty() || has_column(read, measure.column);
               });
  return read;
}

}  // namespace contensou
