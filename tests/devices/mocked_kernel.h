#pragma once
// Devices that are not there: umockdev puts itself between a program and the kernel, and here is the other
// side, where a test answers the system calls. For programs that run under umockdev-wrapper.

#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include <umockdev.h>

namespace carom::test {

struct GObjectDeleter {
  void operator()(gpointer object) const { g_object_unref(object); }
};

/// A device node whose system calls are answered one after another on a thread of umockdev's.
class MockedNode {
 public:
  MockedNode() : base_(umockdev_ioctl_base_new()) {
    g_signal_connect(base_.get(), "handle-ioctl", G_CALLBACK(onIoctl), this);
    g_signal_connect(base_.get(), "handle-read", G_CALLBACK(onRead), this);
    g_signal_connect(base_.get(), "handle-write", G_CALLBACK(onWrite), this);
  }
  MockedNode(const MockedNode&) = delete;
  MockedNode& operator=(const MockedNode&) = delete;
  virtual ~MockedNode() = default;

  UMockdevIoctlBase* base() const { return base_.get(); }

 protected:
  /// Answers with umockdev_ioctl_client_complete and returns true, or leaves it: no such request.
  virtual bool ioctl(UMockdevIoctlClient* client, gulong request, UMockdevIoctlData* argument) = 0;
  virtual bool read(UMockdevIoctlClient* /*client*/, UMockdevIoctlData* /*buffer*/) { return false; }
  virtual bool write(UMockdevIoctlClient* /*client*/, UMockdevIoctlData* /*bytes*/) { return false; }

 private:
  static gboolean onIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    return static_cast<MockedNode*>(self)->ioctl(client, umockdev_ioctl_client_get_request(client),
                                                 umockdev_ioctl_client_get_arg(client));
  }
  static gboolean onRead(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    return static_cast<MockedNode*>(self)->read(client, umockdev_ioctl_client_get_arg(client));
  }
  static gboolean onWrite(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
    return static_cast<MockedNode*>(self)->write(client, umockdev_ioctl_client_get_arg(client));
  }

  std::unique_ptr<UMockdevIoctlBase, GObjectDeleter> base_;
};

/// A machine into which devices are plugged.
class MockedKernel {
 public:
  MockedKernel() : testbed_(umockdev_testbed_new()) {
    if (!umockdev_in_mock_environment()) throw std::logic_error("run this under umockdev-wrapper");
  }

  /// `description`: in umockdev's text format.
  void plugIn(const std::string& description) {
    GError* error = nullptr;
    if (umockdev_testbed_add_from_string(testbed_.get(), description.c_str(), &error)) return;
    const std::string message = error->message;
    g_error_free(error);
    throw std::runtime_error(message);
  }

  void attach(const std::string& node, MockedNode& answers) {
    if (!umockdev_testbed_attach_ioctl(testbed_.get(), node.c_str(), answers.base(), nullptr)) {
      throw std::runtime_error("cannot attach " + node);
    }
  }

  void detach(const std::string& node) {
    umockdev_testbed_detach_ioctl(testbed_.get(), node.c_str(), nullptr);
  }

  /// As the kernel does: the node and its description vanish, and those who listen are told.
  void unplug(const std::string& systemPath) {
    umockdev_testbed_uevent(testbed_.get(), systemPath.c_str(), "remove");
    umockdev_testbed_remove_device(testbed_.get(), systemPath.c_str());
  }

  /// Replays what was captured of the device at `systemPath`; see usb_capture.h.
  void replay(const std::string& systemPath, const std::string& pcapFile) {
    if (umockdev_testbed_load_pcap(testbed_.get(), systemPath.c_str(), pcapFile.c_str(), nullptr)) return;
    throw std::runtime_error("cannot replay " + pcapFile);
  }

  /// The folder in which /sys and /dev are.
  std::string root() const {
    gchar* const text = umockdev_testbed_get_root_dir(testbed_.get());
    const std::string path = text;
    g_free(text);
    return path;
  }

 private:
  std::unique_ptr<UMockdevTestbed, GObjectDeleter> testbed_;
};

/// While it lives, the program is not root's, whom nothing is forbidden; and nothing is but `node`.
class Unprivileged {
 public:
  Unprivileged(const MockedKernel& kernel, const std::string& node) : wasRoot_(geteuid() == 0) {
    namespace fs = std::filesystem;
    if (wasRoot_) {
      fs::permissions(kernel.root(), fs::perms::all);
      for (const auto& entry : fs::recursive_directory_iterator(kernel.root())) {
        if (!entry.is_symlink()) fs::permissions(entry, fs::perms::all);
      }
    }
    fs::permissions(kernel.root() + node, fs::perms::none);
    if (!wasRoot_) return;
    if (setresuid(kNobody, kNobody, 0) != 0) throw std::runtime_error("cannot become nobody");
  }
  Unprivileged(const Unprivileged&) = delete;
  Unprivileged& operator=(const Unprivileged&) = delete;
  ~Unprivileged() {
    if (wasRoot_ && setresuid(0, 0, 0) != 0) std::abort();
  }

 private:
  static constexpr uid_t kNobody = 65534;
  bool wasRoot_;
};

}  // namespace carom::test
