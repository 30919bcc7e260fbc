// The headset of a program that was built without OpenXR: there is none.

#include <stdexcept>

#include "cave/headset/headset.h"

namespace carom {
namespace {

constexpr const char* kWithout =
    "this program was built without OpenXR, expected one that was built where libopenxr-dev is installed";

}  // namespace

struct Headset::Session {
  std::string none;
};

Headset::Headset(const Graphics&) { throw std::runtime_error(kWithout); }
Headset::~Headset() = default;
Headset::State Headset::poll() { return State::ended; }
Headset::State Headset::state() const { return State::ended; }
std::optional<HeadsetFrame> Headset::nextFrame() { return {}; }
void Headset::submit(const std::array<unsigned, 2>*) {}
void Headset::knock(double, double) {}
void Headset::askToEnd() {}
glm::ivec2 Headset::pixels() const { return {}; }
const std::string& Headset::runtime() const { return session_->none; }
const std::string& Headset::system() const { return session_->none; }
bool Headset::hasFloor() const { return false; }
bool Headset::takesEncoded() const { return false; }
const std::string& Headset::whyEnded() const { return session_->none; }

std::string aboutHeadsets() { return kWithout; }

}  // namespace carom
