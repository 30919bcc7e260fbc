#include "cave/audio/sounds.h"

#include <AL/al.h>
#include <AL/alc.h>
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>

#include "cave/audio/heard.h"
#include "engine/text/log.h"

namespace carom {
namespace {

constexpr std::array kSounding{EventKind::puckPuck, EventKind::puckCushion, EventKind::stroke};
constexpr std::size_t kVoices = 16;  // sounds that can play at the same time

/// A decaying tone.
struct Ring {
  double pitch_hz, loudness, fades_s;
};

/// Returns the tones of each kind: a hard clack of two pucks, the dull knock of rubber, the tap of a leather
/// tip.
std::array<Ring, 3> ringsOf(EventKind kind) {
  switch (kind) {
    case EventKind::puckPuck:
      return {{{2350.0, 0.55, 0.014}, {3710.0, 0.35, 0.008}, {6100.0, 0.2, 0.003}}};
    case EventKind::puckCushion:
      return {{{170.0, 0.6, 0.045}, {395.0, 0.3, 0.022}, {1150.0, 0.15, 0.004}}};
    default:
      return {{{760.0, 0.5, 0.012}, {1490.0, 0.3, 0.007}, {4300.0, 0.25, 0.002}}};
  }
}

void saysNothing(const char*, int, const char*, int, const char*, ...) {}

/// Silences ALSA and OpenAL, which list at length what they have tried if there is no device. The person gets
/// a message of our own instead.
void hushLibraries() {
  using Handler = decltype(&saysNothing);
  setenv("ALSOFT_LOGLEVEL", "0", 0);
  void* alsa = dlopen("libasound.so.2", RTLD_LAZY);  // the same library that OpenAL opens
  if (!alsa) return;
  const auto handleErrors = reinterpret_cast<int (*)(Handler)>(dlsym(alsa, "snd_lib_error_set_handler"));
  if (handleErrors) handleErrors(saysNothing);
}

}  // namespace

std::vector<short> clickOf(EventKind kind) {
  constexpr double kLength_s = 0.25, kRise_s = 0.0004;
  std::vector<short> samples(static_cast<std::size_t>(kLength_s * kSoundRate_hz));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t_s = static_cast<double>(i) / kSoundRate_hz;
    double value = 0.0;
    for (const Ring& ring : ringsOf(kind)) {
      value += ring.loudness * std::exp(-t_s / ring.fades_s) *
               std::sin(2.0 * std::numbers::pi * ring.pitch_hz * t_s);
    }
    samples[i] = static_cast<short>(30000.0 * std::clamp(value * std::min(1.0, t_s / kRise_s), -1.0, 1.0));
  }
  return samples;
}

struct Sounds::Device {
  ALCdevice* device = nullptr;
  ALCcontext* context = nullptr;
  std::array<ALuint, kSounding.size()> buffers{};
  std::array<ALuint, kVoices> voices{};
  std::size_t next = 0;
  SoundAxes axes;
  std::optional<ObserverView> before;
  std::vector<Heard> heard;

  Device() = default;
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  ~Device() {
    if (context) {
      alDeleteSources(static_cast<ALsizei>(voices.size()), voices.data());
      alDeleteBuffers(static_cast<ALsizei>(buffers.size()), buffers.data());
      alcMakeContextCurrent(nullptr);
      alcDestroyContext(context);
    }
    if (device) alcCloseDevice(device);
  }

  bool open() {
    hushLibraries();
    device = alcOpenDevice(nullptr);
    if (device) context = alcCreateContext(device, nullptr);
    if (!context || !alcMakeContextCurrent(context)) return false;
    alGenBuffers(static_cast<ALsizei>(buffers.size()), buffers.data());
    alGenSources(static_cast<ALsizei>(voices.size()), voices.data());
    for (std::size_t i = 0; i < kSounding.size(); ++i) {
      const std::vector<short> samples = clickOf(kSounding[i]);
      alBufferData(buffers[i], AL_FORMAT_MONO16, samples.data(),
                   static_cast<ALsizei>(samples.size() * sizeof(short)), kSoundRate_hz);
    }
    for (const ALuint voice : voices) {
      alSourcei(voice, AL_SOURCE_RELATIVE, AL_TRUE);
      alSourcef(voice, AL_ROLLOFF_FACTOR, 0.0F);  // the loudness already includes the distance
    }
    return alGetError() == AL_NO_ERROR;
  }

  /// Plays an event; OpenAL's axes are right, up, back.
  void play(const Heard& event) {
    constexpr double kLowest = 0.25, kHighest = 4.0;
    const double away_m = glm::length(event.seen_m);
    const glm::dvec3 way = away_m > 0.0 ? event.seen_m / away_m : axes.forward;
    const auto coordinate = [&](const glm::dvec3& axis) { return static_cast<float>(glm::dot(way, axis)); };
    const ALuint voice = voices[next++ % kVoices];
    const auto sort = std::find(kSounding.begin(), kSounding.end(), event.kind) - kSounding.begin();
    alSourceStop(voice);
    alSourcei(voice, AL_BUFFER, static_cast<ALint>(buffers[static_cast<std::size_t>(sort)]));
    alSource3f(voice, AL_POSITION, coordinate(axes.right), coordinate(axes.up), coordinate(-axes.forward));
    alSourcef(voice, AL_GAIN, static_cast<float>(event.loudness));
    alSourcef(voice, AL_PITCH, static_cast<float>(std::clamp(event.doppler, kLowest, kHighest)));
    alSourcePlay(voice);
  }
};

std::string soundDeviceName() {
  hushLibraries();
  ALCdevice* device = alcOpenDevice(nullptr);
  if (!device) return {};
  const bool namesAll = alcIsExtensionPresent(nullptr, "ALC_ENUMERATE_ALL_EXT") == ALC_TRUE;
  const std::string name = alcGetString(device, namesAll ? ALC_ALL_DEVICES_SPECIFIER : ALC_DEVICE_SPECIFIER);
  alcCloseDevice(device);
  return name;
}

Sounds::Sounds(const SoundAxes& axes) : device_(std::make_unique<Device>()) {
  device_->axes = axes;
  device_->heard.reserve(2 * kVoices);
  if (device_->open()) return;
  device_.reset();
  log::note("There is no sound device: the session is silent.");
}

Sounds::~Sounds() = default;

void Sounds::shown(const FrameRecord& record, const std::vector<GameEvent>& events) {
  if (!device_) return;
  if (device_->before) {
    heardBetween(*device_->before, record.viewers.front().observer, record.switches, events, device_->heard);
    for (const Heard& event : device_->heard) device_->play(event);
  }
  device_->before = record.viewers.front().observer;
}

}  // namespace carom
