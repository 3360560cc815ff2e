// SPDX-License-Identifier: GPL-3.0-or-later
#include "fits/followed_collision.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "readers/input_error.hpp"

namespace mdana {
namespace {

using Rows = std::vector<MotionSample>;

void check_rows(const Rows& rows, const std::string& place) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!std::isfinite(rows[i].delta.value))
      throw InputError(fmt::format("{}: delta of row {} is not a number", place, i + 1));
    if (i > 0 && !(rows[i].time > rows[i - 1].time))
      throw InputError(fmt::format("{}: time does not rise from row {} to {}", place, i, i + 1));
  }
}

constexpr double nothing = 1e-6;  ///< of the greatest delta: where a motion may begin, as by rounding

/// The last row with delta <= 0 before the first with delta > 0.
std::size_t crossing_row(const Rows& rows, const std::string& place) {
  if (rows.size() < 4) throw InputError(fmt::format("{}: {} rows: a motion needs at least 4", place, rows.size()));
  const auto by_delta = [](const MotionSample& r) { return r.delta.value; };
  if (rows.front().delta.value > nothing * by_delta(*std::ranges::max_element(rows, {}, by_delta)))
    throw InputError(fmt::format("{}: the motion begins in contact (delta {:g}): the speed at delta = 0 is not known",
                                 place, rows.front().delta.value));
  const auto above =
      std::ranges::find_if(rows.begin() + 1, rows.end(), [](const MotionSample& r) { return r.delta.value > 0; });
  if (above == rows.end())
    throw InputError(place + ": delta never rises above 0; if R is greater than that of the table, compute delta anew "
                             "(of a dump: -p R=VALUE)");
  return static_cast<std::size_t>(above - rows.begin()) - 1;
}

/// A cubic in Newton's form on the nodes t.
struct Cubic {
  double t[4], c[4];

  double value(double x) const {
    return c[0] + (x - t[0]) * (c[1] + (x - t[1]) * (c[2] + (x - t[2]) * c[3]));
  }
  double slope(double x) const {
    const double a = x - t[0], b = x - t[1], d = x - t[2];
    return c[1] + c[2] * (a + b) + c[3] * (a * b + a * d + b * d);
  }
};

/// Through rows i and i + 1 and their velocities.
Cubic by_velocities(const Rows& rows, std::size_t i) {
  const MotionSample &a = rows[i], &b = rows[i + 1];
  const double h = b.time - a.time, rise = (b.delta.value - a.delta.value) / h;
  const double first = (rise - a.velocity.value) / h, second = (b.velocity.value - rise) / h;
  return {{a.time, a.time, b.time, b.time}, {a.delta.value, a.velocity.value, first, (second - first) / h}};
}

/// Through four rows about i and i + 1.
Cubic by_rows(const Rows& rows, std::size_t i) {
  const std::size_t first = std::min(i > 0 ? i - 1 : 0, rows.size() - 4);
  Cubic p{};
  for (std::size_t k = 0; k < 4; ++k) p.t[k] = rows[first + k].time, p.c[k] = rows[first + k].delta.value;
  for (std::size_t order = 1; order < 4; ++order)
    for (std::size_t k = 3; k >= order; --k) p.c[k] = (p.c[k] - p.c[k - 1]) / (p.t[k] - p.t[k - order]);
  return p;
}

/// Where the cubic passes zero between two times at which its signs differ, or the first if it is zero there.
double zero_of(const Cubic& p, double low, double high) {
  if (p.value(low) >= 0) return low;
  for (int k = 0; k < 200 && high - low > 1e-16 * std::abs(high); ++k) {
    const double middle = (low + high) / 2;
    if (middle <= low || middle >= high) break;
    (p.value(middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// One behind the last row of the first compression and what follows from it.
std::size_t end_of_collision(const Rows& rows, std::size_t first, const std::string& place) {
  const auto delta = [&](std::size_t i) { return rows[i].delta.value; };
  std::size_t turn = first + 1;
  while (turn + 1 < rows.size() && delta(turn + 1) >= delta(turn)) ++turn;
  if (turn + 1 == rows.size())
    throw InputError(place + ": delta never falls again: the motion ends before its first turn");
  std::size_t end = turn + 1;
  while (end < rows.size() && delta(end) < delta(end - 1) && delta(end) > -delta(turn)) ++end;
  return end;
}

}  // namespace

ObservedCollision followed_collision(const Rows& rows, const std::string& place) {
  check_rows(rows, place);
  const std::size_t first = crossing_row(rows, place), end = end_of_collision(rows, first, place);
  const bool velocities = rows[first].velocity.known() && rows[first + 1].velocity.known();
  const Cubic path = velocities ? by_velocities(rows, first) : by_rows(rows, first);
  const double start = zero_of(path, rows[first].time, rows[first + 1].time), speed = path.slope(start);
  if (!(speed > 0)) throw InputError(fmt::format("{}: the speed at delta = 0 is {:g}", place, speed));
  ObservedCollision c;
  c.place = place;
  c.given = {{"v", speed}};
  for (std::size_t i = first; i < end; ++i) {
    c.motion.push_back(rows[i]);
    c.motion.back().time -= start;
  }
  return c;
}

}  // namespace mdana
