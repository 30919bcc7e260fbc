#include "devices/usb/polhemus_tracker.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "devices/protocol/polhemus_decoder.h"
#include "devices/tracker/retry.h"
#include "devices/tracker/stoppable_wait.h"
#include "devices/usb/polhemus_models.h"
#include "devices/usb/usb_handles.h"

namespace carom {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr std::size_t kPending = 8;    // transfers that wait for the device at any moment
constexpr int kMostErrors = 8;         // failed transfers in a row until the connection is given up
constexpr auto kPolhemusSilence = 2s;  // until the device is set up again
constexpr auto kLookForPolhemus = 500ms;
constexpr auto kBetweenCommands = 20ms;
constexpr unsigned kTransfer_ms = 100;
constexpr auto kLongestDrain = 500ms;  // a device that will not be quiet is set up all the same

// "P" and "c" end continuous records. LIBERTY: F1 binary, U1 centimetres, O what a record holds, X and Y the
// position and attitude filters off. FASTRAK: f, U, O, x and v likewise; its one-letter commands take no
// return.
constexpr std::array<std::string_view, 2> kQuietLiberty{"\r", "P\r"};
constexpr std::array<std::string_view, 5> kSetUpLiberty{"F1\r", "U1\r", "O*,8,9,11,3,7\r", "X0,1,0,0\r",
                                                        "Y0,1,0,0\r"};
constexpr std::array<std::string_view, 1> kQuietFastrak{"c"};
constexpr std::array<std::string_view, 8> kSetUpFastrak{
    "f", "U", "O1,2,11,0\r", "O2,2,11,0\r", "O3,2,11,0\r", "O4,2,11,0\r", "x0,1,0,0\r", "v0,1,0,0\r"};

/// Records as they come: transfers are always waiting, each as long as one packet, so that a packet is here
/// as soon as the device has sent it.
class Stream {
 public:
  Stream(libusb_context* context, libusb_device_handle* handle, const PolhemusModel& model, DeviceSink& sink)
      : context_(context), handle_(handle), model_(model), sink_(sink), decoder_(model.format) {
    readings_.reserve(64);
    const int packet = libusb_get_max_packet_size(libusb_get_device(handle), model.dataEndpoint);
    packet_ = std::clamp(packet, 64, 1024);
  }

  /// Returns why it ended: empty where it was stopped.
  std::string run(const std::stop_token& stop) {
    lastCame_ = Clock::now();
    for (Slot& slot : slots_) submit(slot);
    while (!stop.stop_requested() && ended_.empty()) {
      handleEvents();
      if (Clock::now() - lastCame_ > kPolhemusSilence)
        ended_ = "it has sent nothing for two seconds (is a sensor plugged into it?)";
    }
    const std::string why = ended_;
    withdraw();
    return why;
  }

 private:
  struct Slot {
    Stream* stream = nullptr;
    std::vector<std::uint8_t> bytes;
    std::unique_ptr<libusb_transfer, void (*)(libusb_transfer*)> transfer{libusb_alloc_transfer(0),
                                                                          libusb_free_transfer};
    bool pending = false;
  };

  void submit(Slot& slot) {
    slot.stream = this;
    slot.bytes.resize(static_cast<std::size_t>(packet_));
    libusb_fill_bulk_transfer(slot.transfer.get(), handle_, model_.dataEndpoint, slot.bytes.data(), packet_,
                              arrived, &slot, 0);
    if (model_.dataByInterrupt) slot.transfer->type = LIBUSB_TRANSFER_TYPE_INTERRUPT;
    resubmit(slot);
  }

  void resubmit(Slot& slot) {
    const int result = libusb_submit_transfer(slot.transfer.get());
    slot.pending = result == LIBUSB_SUCCESS;
    if (!slot.pending && ended_.empty()) {
      ended_ = result == LIBUSB_ERROR_NO_DEVICE ? "it was unplugged" : libusb_strerror(result);
    }
  }

  static void LIBUSB_CALL arrived(libusb_transfer* transfer) {
    Slot& slot = *static_cast<Slot*>(transfer->user_data);
    slot.stream->take(slot);
  }

  void take(Slot& slot) {
    slot.pending = false;
    switch (slot.transfer->status) {
      case LIBUSB_TRANSFER_COMPLETED:
        errors_ = 0;
        decode({slot.bytes.data(), static_cast<std::size_t>(slot.transfer->actual_length)});
        break;
      case LIBUSB_TRANSFER_NO_DEVICE:
        if (ended_.empty()) ended_ = "it was unplugged";
        break;
      case LIBUSB_TRANSFER_CANCELLED:
        break;
      default:  // error, stall, overflow
        sink_.refused();
        if (++errors_ >= kMostErrors && ended_.empty()) ended_ = "transfers fail, one after another";
        break;
    }
    if (ended_.empty() && !withdrawing_) resubmit(slot);
  }

  void decode(std::span<const std::uint8_t> bytes) {
    const Clock::time_point now = Clock::now();
    if (!bytes.empty()) lastCame_ = now;
    readings_.clear();
    decoder_.decode(bytes, readings_);
    if (!readings_.empty()) sink_.deliver(readings_, now);
    for (; refused_ < decoder_.refused(); ++refused_) sink_.refused();
    if (decoder_.missed() > missed_) sink_.missed(decoder_.missed() - missed_);
    missed_ = decoder_.missed();
  }

  void handleEvents() {
    timeval wait{0, 50'000};
    libusb_handle_events_timeout_completed(context_, &wait, nullptr);
  }

  /// Takes the waiting transfers back; their memory may go only when all have come.
  void withdraw() {
    withdrawing_ = true;
    for (Slot& slot : slots_) {
      if (slot.pending) libusb_cancel_transfer(slot.transfer.get());
    }
    while (std::any_of(slots_.begin(), slots_.end(), [](const Slot& slot) { return slot.pending; }))
      handleEvents();
  }

  libusb_context* context_;
  libusb_device_handle* handle_;
  const PolhemusModel& model_;
  DeviceSink& sink_;
  PolhemusDecoder decoder_;
  std::array<Slot, kPending> slots_;
  std::vector<Reading> readings_;
  int packet_;
  Clock::time_point lastCame_;
  std::uint64_t refused_ = 0;
  std::uint64_t missed_ = 0;
  int errors_ = 0;
  bool withdrawing_ = false;
  std::string ended_;  // why
};

class Polhemus {
 public:
  Polhemus(const UsbAddress& address, const PolhemusModel& model, const std::stop_token& stop,
           DeviceSink& sink)
      : address_(address), model_(model), stop_(stop), sink_(sink), context_(openUsb()) {}

  /// Finds the device and uses it until it is gone or a stop is asked for. Throws if that is impossible.
  void run() {
    if (!context_) throw NeedsHelp("this system has no USB");
    find();
    const std::string why = use();
    handle_.reset();
    if (!stop_.stop_requested()) throw std::runtime_error(name() + ": " + why);
  }

 private:
  std::string name() const {
    return std::string("Polhemus ") + model_.name + " (" + toString(address_) + ')';
  }

  void find() {
    bool bare = false;
    for (const UsbDeviceEntry& entry : listUsb(context_.get())) {
      if (entry.vendor != kPolhemusVendor) continue;
      bare = bare || entry.product == model_.bareProduct;
      if (entry.product != model_.product) continue;
      libusb_device_handle* handle = nullptr;
      const int result = libusb_open(entry.device.get(), &handle);
      if (result == LIBUSB_ERROR_ACCESS) {
        throw NeedsHelp(
            name() + ": " + entry.node +
            " may not be opened by this user: copy config/udev/70-carom.rules to /etc/udev/rules.d "
            "and plug the tracker in again");
      }
      UsbHandle opened(result == LIBUSB_SUCCESS ? handle : nullptr);
      if (!opened || (!address_.serial.empty() && serialOf(handle) != address_.serial)) continue;
      handle_ = std::move(opened);
      return;
    }
    if (!bare) throw std::runtime_error(name() + " is not plugged in");
    throw NeedsHelp(name() +
                    " needs firmware: it shows as a bare USB chip until its .hex file has been loaded "
                    "with fxload");
  }

  /// Returns why it ended.
  std::string use() {
    int configuration = 0;
    if (libusb_get_configuration(handle_.get(), &configuration) == LIBUSB_SUCCESS && configuration != 1) {
      libusb_set_configuration(handle_.get(), 1);
    }
    const int claimed = libusb_claim_interface(handle_.get(), 0);
    if (claimed == LIBUSB_ERROR_BUSY) return "another program uses it";
    if (claimed != LIBUSB_SUCCESS) return libusb_strerror(claimed);
    if (!beQuiet() || !setUp()) return "it does not take commands";
    sink_.connected();
    std::string why = Stream(context_.get(), handle_.get(), model_, sink_).run(stop_);
    beQuiet();
    libusb_release_interface(handle_.get(), 0);
    return why;
  }

  bool fastrak() const { return model_.format == PolhemusFormat::fastrak; }

  bool beQuiet() {
    const bool taken = fastrak() ? sendAll(kQuietFastrak) : sendAll(kQuietLiberty);
    drain(model_.dataEndpoint);
    if (model_.dataEndpoint != model_.replyEndpoint) drain(model_.replyEndpoint);
    return taken;
  }

  bool setUp() {
    const bool taken = fastrak() ? sendAll(kSetUpFastrak) : sendAll(kSetUpLiberty);
    drain(model_.replyEndpoint);
    return taken && send(fastrak() ? "C" : "C\r");
  }

  bool sendAll(std::span<const std::string_view> commands) {
    for (const std::string_view command : commands) {
      if (!send(command)) return false;
      waitUnlessStopped(stop_, kBetweenCommands);
    }
    return true;
  }

  bool send(std::string_view command) {
    std::array<unsigned char, 32> bytes{};
    std::copy(command.begin(), command.end(), bytes.begin());
    int sent = 0;
    const int size = static_cast<int>(command.size());
    const int result =
        libusb_bulk_transfer(handle_.get(), model_.commandEndpoint, bytes.data(), size, &sent, kTransfer_ms);
    return result == LIBUSB_SUCCESS && sent == size;
  }

  /// Reads and drops pending data until nothing more comes.
  void drain(std::uint8_t endpoint) {
    std::array<unsigned char, 1024> bytes;
    const bool interrupt = model_.dataByInterrupt && endpoint == model_.dataEndpoint;
    const bool hurry = stop_.stop_requested();
    const unsigned wait_ms = hurry ? kTransfer_ms / 4 : kTransfer_ms;
    const Clock::time_point until = Clock::now() + (hurry ? kLongestDrain / 8 : kLongestDrain);
    while (Clock::now() < until) {
      int size = 0;
      const auto transfer = interrupt ? libusb_interrupt_transfer : libusb_bulk_transfer;
      const int result =
          transfer(handle_.get(), endpoint, bytes.data(), static_cast<int>(bytes.size()), &size, wait_ms);
      if (result != LIBUSB_SUCCESS && size == 0) return;
    }
  }

  const UsbAddress& address_;
  const PolhemusModel& model_;
  const std::stop_token& stop_;
  DeviceSink& sink_;
  UsbContext context_;
  UsbHandle handle_;
};

}  // namespace

Transport polhemusTransport(const UsbAddress& address) {
  const PolhemusModel* const model = findPolhemusModel(address.product);
  if (address.vendor != kPolhemusVendor || model == nullptr) {
    throw std::invalid_argument(toString(address) +
                                " is no Polhemus tracker: expected 0f44:0002 (FASTRAK), "
                                "0f44:ef12 (PATRIOT) or 0f44:ff12 (LIBERTY), or one of their relatives");
  }
  return [address, model](const std::stop_token& stop, DeviceSink& sink) {
    Polhemus polhemus(address, *model, stop, sink);
    retry(stop, sink, kLookForPolhemus, [&] { polhemus.run(); });
  };
}

}  // namespace carom
