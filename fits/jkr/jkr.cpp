// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "fits/jkr_contact.hpp"

namespace mdana {
namespace {

double force(double delta, const ElasticContact& c) {
  return c.modulus * c.radius * c.radius * jkr_contact(delta, c).force();
}

double contact_radius(double delta, const ElasticContact& c) {
  return c.radius * jkr_contact(delta, c).a;
}

double least_delta(const ElasticContact& c) {
  return c.radius * jkr_least_delta(c.surface_energy / c.radius / c.modulus);
}

double stiffness(double delta, const ElasticContact& c) {
  return c.modulus * c.radius * jkr_contact(delta, c).stiffness();
}

double energy(double delta, const ElasticContact& c) {
  return c.modulus * c.radius * c.radius * c.radius * jkr_contact(delta, c).energy();
}

double pressure(double r, double delta, const ElasticContact& c) {
  return c.modulus * jkr_contact(delta, c).pressure(r / c.radius);
}

constexpr std::array parameters{contact_parameter::radius, contact_parameter::modulus,
                                contact_parameter::surface_energy};

}  // namespace

extern const ForceLaw jkr_law;
const ForceLaw jkr_law{
    {force, contact_radius, least_delta, stiffness, energy, pressure, contact_radius},
    "jkr",
    "elastic spheres with short-range adhesion",
    parameters};

}  // namespace mdana
