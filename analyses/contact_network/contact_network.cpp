// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/contact_network.hpp"

#include "analyses/contact_network/network_numbers.hpp"
#include "analyses/parcel.hpp"

namespace mdana {
namespace {

class ContactNetworkPartial final : public Partial {
 public:
  ContactNetworkPartial(const FrameContext& frame, const ContactNetworkSettings& settings)
      : centre_{frame.motion[0].position, frame.motion[1].position},
        plane_(frame.motion[0], frame.motion[1], settings.radius, frame.header.place),
        step_(frame.header.step),
        settings_(settings) {}

  void add(const LabelledBlock& block) override {
    const auto x = block.atoms.real("x"), y = block.atoms.real("y"), z = block.atoms.real("z");
    const auto radius =
        settings_.grain_radius ? std::span<const double>() : block.atoms.real("radius");
    const auto id =
        settings_.followed() ? block.atoms.integer("id") : std::span<const std::int64_t>();
    for (std::size_t i = 0; i < x.size(); ++i) {
      const BodyIndex b = block.body[i];
      if (b != 1 && b != 2) continue;
      grains_.push_back({{x[i], y[i], z[i]},
                         radius.empty() ? *settings_.grain_radius : radius[i],
                         b,
                         id.empty() ? 0 : id[i]});
    }
  }

  void merge(const Partial& later) override {
    const auto& other = dynamic_cast<const ContactNetworkPartial&>(later);
    grains_.insert(grains_.end(), other.grains_.begin(), other.grains_.end());
  }

  void pass(Parcel& parcel) override { parcel(grains_); }

  void close(std::span<double> row) const override {
    std::vector<GrainContact> contacts = find_contacts(grains_, settings_.law);
    NetworkNumbers numbers;
    if (const LocalFrame* list = settings_.listed ? settings_.listed(step_) : nullptr) {
      const ListedShare share = decide_by_list(grains_, contacts, list->contacts);
      numbers.listed = static_cast<double>(share.listed);
      numbers.unmatched = static_cast<double>(share.unmatched);
    }
    const NetworkFrame frame{grains_, contacts, centre_, plane_, settings_};
    count_contacts(frame, numbers);
    compare_with_reference(frame, numbers);
    measure_forces(frame, numbers);
    measure_fabric(frame, numbers);
    measure_filling(frame, numbers);
    write_row(numbers, settings_, row);
  }

 private:
  std::array<Eigen::Vector3d, 2> centre_;
  ContactPlane plane_;
  std::int64_t step_;
  const ContactNetworkSettings& settings_;
  std::vector<Grain> grains_;  ///< in the order of the file
};

class ContactNetwork final : public Analysis {
 public:
  explicit ContactNetwork(ContactNetworkSettings settings) : settings_(std::move(settings)) {}

  Needs needs() const override {
    ColumnSet wanted{"x", "y", "z"};
    if (!settings_.grain_radius) wanted.add("radius");
    if (settings_.followed()) wanted.add("id");
    return {wanted, /*after_motion=*/true};
  }
  std::vector<ColumnSpec> columns() const override { return network_columns(settings_); }
  std::unique_ptr<Partial> begin(const FrameContext& frame) const override {
    return std::make_unique<ContactNetworkPartial>(frame, settings_);
  }

 private:
  ContactNetworkSettings settings_;
};

/// Without column and scene, a guess that makes little work.
std::optional<double> default_grain_radius(const AnalysisSetup& setup) {
  if (setup.first.has_column("radius")) return std::nullopt;
  return setup.scene.grains.radius.value_or(setup.scene.sigma.value_or(1.0) / 16);
}

}  // namespace

std::unique_ptr<Analysis> make_contact_network(ContactNetworkSettings settings) {
  return std::make_unique<ContactNetwork>(std::move(settings));
}

extern const AnalysisMember contact_network_analysis;
const AnalysisMember contact_network_analysis{
    "contact_network", "contacts of the grains of two aggregates", [](const AnalysisSetup& setup) {
      const bool known = setup.scene.radii.size() == 2;
      ContactNetworkSettings settings;
      settings.radius = {known ? setup.scene.radii[0] : 1.0, known ? setup.scene.radii[1] : 1.0};
      settings.grain_radius = default_grain_radius(setup);
      return make_contact_network(std::move(settings));
    }};

}  // namespace mdana
