// SPDX-License-Identifier: GPL-3.0-or-later
#include "analyses/defects/sent_atoms.hpp"

#include "analyses/parcel.hpp"

namespace mdana::defects {

void send_atoms(const LabelledAtoms& atoms, const std::function<void(const std::string&)>& to) {
  Parcel head;
  std::size_t size = atoms.size();
  head(size);
  to(head.take());
  atoms.for_blocks([&](FrameAtoms block, AtomLabels labels) {
    Parcel parcel;
    parcel(block, labels);
    to(parcel.take());
  });
}

SentAtoms::SentAtoms(const std::function<std::string()>& from) : from_(from) {
  Parcel head(from_());
  head(size_);
  left_ = size_;
}

void SentAtoms::for_blocks(const std::function<void(const FrameAtoms&, const AtomLabels&)>& use) const {
  while (left_ > 0) {
    Parcel parcel(from_());
    FrameAtoms block;
    AtomLabels labels;
    parcel(block, labels);
    left_ -= block.size();
    use(block, labels);
  }
}

}  // namespace mdana::defects
