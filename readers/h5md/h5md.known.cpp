// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <random>

#include <fmt/format.h>

#include "readers/hdf5.hpp"
#include "readers/known_answer.hpp"
#include "readers/trajectory.hpp"

namespace mdana {

std::vector<KnownAnswer> h5md_known();

namespace {

/// A file of its own, which is gone afterwards.
class KnownFile {
 public:
  KnownFile()
      : path(std::filesystem::temp_directory_path() /
             fmt::format("mdana-known-{:08x}.h5", std::random_device{}())) {}
  ~KnownFile() { std::filesystem::remove(path); }
  KnownFile(const KnownFile&) = delete;
  KnownFile& operator=(const KnownFile&) = delete;

  const std::filesystem::path path;
};

void put(hdf5::Group& group, const std::string& name, const hdf5::Shape& shape,
         const std::vector<double>& values) {
  group.make_dataset(name, {hdf5::Kind::real, shape})
      .write({hdf5::Shape(shape.size(), 0), shape}, values);
}

void put(hdf5::Group& group, const std::string& name, const hdf5::Shape& shape,
         const std::vector<std::int64_t>& values) {
  group.make_dataset(name, {hdf5::Kind::integer, shape})
      .write({hdf5::Shape(shape.size(), 0), shape}, values);
}

// Edges a = (8, 0, 0), b = (2, 4, 0), c = (-1, 1, 16), one a row; steps 5e9, 5e9 + 100 by an
// increment; two atoms, two frames.
void write(const std::filesystem::path& path) {
  hdf5::Group file = hdf5::create_file(path);
  file.make_group("h5md").set_integers("version", std::vector<std::int64_t>{1, 1});
  hdf5::Group all = file.make_group("particles").make_group("all");
  hdf5::Group box = all.make_group("box");
  box.set_integer("dimension", 3);
  box.set_texts("boundary", std::vector<std::string>{"periodic", "periodic", "none"});
  put(box, "edges", {3, 3}, std::vector<double>{8, 0, 0, 2, 4, 0, -1, 1, 16});
  hdf5::Group position = all.make_group("position"), image = all.make_group("image");
  put(position, "value", {2, 2, 3}, std::vector<double>{0, 0, 0, 0, 0, 0, 1, 2, 3, 0.5, 0.25, 0.125});
  put(image, "value", {2, 2, 3}, std::vector<std::int64_t>{0, 0, 0, 0, 0, 0, 0, 0, 0, 1, -1, 2});
  for (hdf5::Group* element : {&position, &image}) {
    hdf5::Dataset step = element->make_dataset("step", {hdf5::Kind::integer, {}});
    step.write({}, std::vector<std::int64_t>{100});
    step.set_integer("offset", 5'000'000'000);
  }
  put(all, "id", {2}, std::vector<std::int64_t>{7, 3});
}

}  // namespace

std::vector<KnownAnswer> h5md_known() {
  const KnownFile file;
  write(file.path);
  std::vector<KnownAnswer> answers;
  const auto add = [&](std::string what, double computed, double exact) {
    answers.push_back({std::move(what), computed, exact, 16});
  };
  const auto source = open_trajectory(file.path, {"id", "x", "y", "z"});
  FrameHeader header;
  source->next(header);
  source->next(header);
  Chunk chunk;
  source->cut(chunk);
  AtomBlock block;
  convert(chunk, block);
  add("x without image flags", block.real("x")[0], 1);
  add("x with image flags", block.real("x")[1], 0.5 + 8 - 2 - 2);
  add("y with image flags", block.real("y")[1], 0.25 - 4 + 2);
  add("z with image flags", block.real("z")[1], 0.125 + 32);
  add("id", static_cast<double>(block.integer("id")[1]), 3);
  add("step by increment and offset", static_cast<double>(header.step), 5'000'000'100);
  add("edge c, x", header.box.edges(0, 2), -1);
  return answers;
}

}  // namespace mdana
