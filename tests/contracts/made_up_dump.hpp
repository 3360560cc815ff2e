// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace mdana::test {

struct MadeUpAtom {
  std::int64_t id = 0;
  int type = 1;  ///< 1, 2: the bodies
  int mol = 0;
  double mass = 1;
  Eigen::Vector3d x{0, 0, 0}, v{0, 0, 0}, f{0, 0, 0};
  double pe = 0;  ///< potential energy
};

struct MadeUpFrame {
  std::int64_t step = 0;
  std::optional<double> time;
  std::vector<MadeUpAtom> atoms;
};

/// A random ball of atoms with a drift and thermal parts.
inline std::vector<MadeUpAtom> ball(std::mt19937_64& random, int type, std::size_t atoms,
                                    double radius, const Eigen::Vector3d& centre,
                                    const Eigen::Vector3d& drift) {
  std::uniform_real_distribution<double> side(-1, 1);
  const auto vector = [&] { return Eigen::Vector3d(side(random), side(random), side(random)); };
  std::vector<MadeUpAtom> made;
  while (made.size() < atoms) {
    const Eigen::Vector3d p = vector();
    if (p.norm() > 1) continue;
    MadeUpAtom atom;
    atom.type = type;
    atom.x = centre + radius * p;
    atom.v = drift + 1e-3 * vector();
    atom.f = 10 * vector();
    atom.pe = atom.f.x() - 7;
    made.push_back(atom);
  }
  return made;
}

/// Two balls of radius 1 that come together along an oblique line and overlap a little in the end;
/// masses 1 and 3 in both bodies, ids in file order.
inline std::vector<MadeUpFrame> made_up_collision(std::size_t frames, std::size_t atoms_per_body,
                                                  std::uint64_t seed = 1) {
  const Eigen::Vector3d n = Eigen::Vector3d(2, -1, 2) / 3;
  std::vector<MadeUpFrame> made;
  std::mt19937_64 random(seed);
  for (std::size_t i = 0; i < frames; ++i) {
    const double half = 1.05 - 0.1 * static_cast<double>(i);
    MadeUpFrame frame{static_cast<std::int64_t>(100 * i), 0.5 * static_cast<double>(i), {}};
    for (const int type : {1, 2}) {
      const double side = type == 1 ? -1 : 1;
      const auto body = ball(random, type, atoms_per_body, 1, side * half * n, -side * 0.2 * n);
      frame.atoms.insert(frame.atoms.end(), body.begin(), body.end());
    }
    for (std::size_t k = 0; k < frame.atoms.size(); ++k) {
      frame.atoms[k].id = static_cast<std::int64_t>(k + 1);
      frame.atoms[k].mass = k % 3 ? 1 : 3;
      frame.atoms[k].mol = frame.atoms[k].type;
    }
    made.push_back(frame);
  }
  return made;
}

/// A number that is read back as the same bits.
inline void print(std::string& text, double value) {
  char buffer[40];
  text.append(buffer,
              static_cast<std::size_t>(std::snprintf(buffer, sizeof buffer, " %.17g", value)));
}

inline void print(std::string& text, const Eigen::Vector3d& vector) {
  for (const double value : vector) print(text, value);
}

inline std::string dump_text(const MadeUpFrame& frame) {
  std::string text;
  if (frame.time) {
    text += "ITEM: TIME\n";
    print(text, *frame.time);
    text += "\n";
  }
  text += "ITEM: TIMESTEP\n" + std::to_string(frame.step) + "\nITEM: NUMBER OF ATOMS\n" +
          std::to_string(frame.atoms.size()) +
          "\nITEM: BOX BOUNDS ff ff ff\n0 1\n0 1\n0 1\n"
          "ITEM: ATOMS id type mol mass x y z vx vy vz fx fy fz c_pe\n";
  for (const MadeUpAtom& atom : frame.atoms) {
    text +=
        std::to_string(atom.id) + " " + std::to_string(atom.type) + " " + std::to_string(atom.mol);
    print(text, atom.mass);
    print(text, atom.x);
    print(text, atom.v);
    print(text, atom.f);
    print(text, atom.pe);
    text += "\n";
  }
  return text;
}

inline std::string dump_text(const std::vector<MadeUpFrame>& frames) {
  std::string text;
  for (const MadeUpFrame& frame : frames) text += dump_text(frame);
  return text;
}

}  // namespace mdana::test
