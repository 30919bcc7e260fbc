#include "xr_double.h"

#include <dlfcn.h>

#include <GL/glew.h>
#include <GL/glx.h>
#define XR_USE_PLATFORM_XLIB
#define XR_USE_GRAPHICS_API_OPENGL
#include <openxr/openxr_platform.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <utility>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

// How the loader and a runtime agree (the loader's interface, version 1); not in the headers of 1.0.20.
extern "C" {
struct XrNegotiateLoaderInfo {
  std::uint32_t structType, structVersion;
  std::size_t structSize;
  std::uint32_t minInterfaceVersion, maxInterfaceVersion;
  XrVersion minApiVersion, maxApiVersion;
};
struct XrNegotiateRuntimeRequest {
  std::uint32_t structType, structVersion;
  std::size_t structSize;
  std::uint32_t runtimeInterfaceVersion;
  XrVersion runtimeApiVersion;
  PFN_xrGetInstanceProcAddr getInstanceProcAddr;
};
}

namespace carom::test {
namespace {

constexpr XrTime kBegins_ns = 1'000'000'000;
constexpr std::size_t kImages = 3;

struct Chain {
  std::array<GLuint, kImages> textures{};
  glm::ivec2 size{0};
  std::size_t next = 0, last = 0;
  bool isAcquired = false, isAwaited = false;
};
struct Space {
  XrReferenceSpaceType type = XR_REFERENCE_SPACE_TYPE_STAGE;
  int hand = -1;          // or of a hand's aim
  float height_m = 0.0F;  // of its origin
};

XrDouble told;  // the script, and what was seen

/// What the runtime itself remembers.
struct Runtime {
  std::uint64_t handles = 100, frame = 0;
  XrSession session = XR_NULL_HANDLE;
  XrSessionState state = XR_SESSION_STATE_UNKNOWN;
  bool isRunning = false, isAwaited = false, isBegun = false;
  XrTime time = kBegins_ns;
  XrDoubleFrame now;
  std::int64_t located_ns = 0, ours_ns = 0, allocatedBefore = 0, allocated = 0;
  std::vector<std::string> paths{""};
  std::map<XrAction, std::string> actions;
  std::map<XrSpace, Space> spaces;
  std::map<XrSwapchain, Chain> chains;
} runtime;

template <typename Handle>
Handle newHandle() {
  return reinterpret_cast<Handle>(++runtime.handles);
}

XrResult fault(const char* what, XrResult result) {
  std::fprintf(stderr, "xr_double: %s\n", what);
  told.faults.emplace_back(what);
  return result;
}

/// Does what some runtimes do to the application that calls them.
void beRude() {
  if (!told.isRude) return;
  glEnable(GL_INVALID_ENUM);  // leaves an error
  glXMakeCurrent(glXGetCurrentDisplay(), None, nullptr);
}

template <typename Item>
XrResult give(const std::vector<Item>& items, std::uint32_t capacity, std::uint32_t* count, Item* out) {
  *count = static_cast<std::uint32_t>(items.size());
  if (capacity == 0) return XR_SUCCESS;
  if (capacity < items.size()) return XR_ERROR_SIZE_INSUFFICIENT;
  std::copy(items.begin(), items.end(), out);
  return XR_SUCCESS;
}

std::int64_t now_ns() { return std::chrono::steady_clock::now().time_since_epoch().count(); }

/// Returns how often `new` was asked for, if somebody counts.
std::int64_t allocations() {
  using Count = std::size_t();
  static auto* const count = reinterpret_cast<Count*>(dlsym(RTLD_DEFAULT, "caromAllocationCount"));
  return count ? static_cast<std::int64_t>(count()) : 0;
}

using Result = XrResult;

Result XRAPI_CALL enumerateExtensions(const char*, std::uint32_t capacity, std::uint32_t* count,
                                      XrExtensionProperties* out) {
  std::vector<XrExtensionProperties> all;
  for (const char* name : {XR_KHR_OPENGL_ENABLE_EXTENSION_NAME, XR_EXT_HAND_TRACKING_EXTENSION_NAME}) {
    if (!told.hasOpenGl && std::strcmp(name, XR_KHR_OPENGL_ENABLE_EXTENSION_NAME) == 0) continue;
    if (!told.seesHands && std::strcmp(name, XR_EXT_HAND_TRACKING_EXTENSION_NAME) == 0) continue;
    XrExtensionProperties extension{};
    extension.type = XR_TYPE_EXTENSION_PROPERTIES;
    std::snprintf(extension.extensionName, sizeof extension.extensionName, "%s", name);
    extension.extensionVersion = 1;
    all.push_back(extension);
  }
  return give(all, capacity, count, out);
}

/// A line of the script in a file.
struct ScriptLine {
  XrDoubleFrame frame;
  std::string event;
};

/// Returns whether the environment gives the runtime this habit.
bool has(const char* habit) {
  const char* const habits = std::getenv("CAROM_XR_HABITS");
  std::istringstream words(habits ? habits : "");
  for (std::string word; words >> word;) {
    if (word == habit) return true;
  }
  return false;
}

/// Takes on the habits that the environment names.
void takeHabits() {
  if (!std::getenv("CAROM_XR_HABITS")) return;
  told.hasHeadset = !has("no-headset");
  told.hasOpenGl = !has("no-opengl");
  told.seesHands = has("bare-hands");
  told.isRude = has("rude");
  if (has("no-srgb")) told.formats = {0x8058};
  if (has("no-8-bits")) told.formats = {0x881A};
  if (has("large")) told.size = {1024, 1024};
  if (has("silent")) told.keepsPictures = false;
}

void happen(const std::string& event) {
  if (event == "off") {
    told.takeOff();
    for (int i = 0; i < 3; ++i) told.states.push_back(XR_SESSION_STATE_UNKNOWN);
    told.putOn();
  }
  if (event == "recentre") told.recentres = true;
  if (event == "unfocused") told.states.push_back(XR_SESSION_STATE_VISIBLE);
  if (event == "focused") told.states.push_back(XR_SESSION_STATE_FOCUSED);
  if (event == "lost") told.waitResult = XR_ERROR_SESSION_LOST;
}

/// Follows the script in a file.
void follow(const char* file) {
  auto lines = std::make_shared<std::vector<ScriptLine>>();
  std::ifstream in(file);
  for (std::string text; std::getline(in, text);) {
    std::istringstream words(text);
    ScriptLine line;
    XrPosef head{};
    XrDoubleHand& hand = line.frame.hands[1];
    words >> line.frame.step_ns >> line.frame.shouldRender >> line.frame.flags >> head.position.x >>
        head.position.y >> head.position.z >> head.orientation.w >> head.orientation.x >>
        head.orientation.y >> head.orientation.z >> hand.trigger >> hand.aim.position.x >>
        hand.aim.position.y >> hand.aim.position.z >> hand.stick.y >> line.event;
    const glm::quat attitude(head.orientation.w, head.orientation.x, head.orientation.y, head.orientation.z);
    for (std::size_t eye = 0; eye < 2; ++eye) {
      const glm::vec3 aside = attitude * glm::vec3(eye == 0 ? -0.032F : 0.032F, 0.0F, 0.0F);
      line.frame.eyes[eye] = {
          head.orientation,
          {head.position.x + aside.x, head.position.y + aside.y, head.position.z + aside.z}};
    }
    hand.aim.orientation = {-0.3826834F, 0, 0, 0.9238795F};  // 45° down
    line.frame.velocityFlags = has("no-velocity") ? 0 : XR_SPACE_VELOCITY_LINEAR_VALID_BIT;
    if (has("bare-hands")) hand.tipsApart_m = 0.06F - 0.05F * std::exchange(hand.trigger, 0.0F);
    if (has("bare-hands") || has("no-hands")) line.frame.hands[0].flags = hand.flags = 0;
    lines->push_back(line);
  }
  told.script = [lines](std::uint64_t number) {
    if (number + 1 == lines->size()) told.quit();
    const ScriptLine& line = (*lines)[std::min<std::size_t>(number, lines->size() - 1)];
    happen(line.event);
    return line.frame;
  };
}

Result XRAPI_CALL createInstance(const XrInstanceCreateInfo*, XrInstance* out) {
  runtime = {};
  if (const char* file = std::getenv("CAROM_XR_SCRIPT")) follow(file);
  ++told.instances;
  *out = newHandle<XrInstance>();
  return XR_SUCCESS;
}
Result XRAPI_CALL destroyInstance(XrInstance) { return --told.instances, XR_SUCCESS; }
Result XRAPI_CALL instanceProperties(XrInstance, XrInstanceProperties* about) {
  std::snprintf(about->runtimeName, sizeof about->runtimeName, "A runtime for tests");
  about->runtimeVersion = XR_MAKE_VERSION(1, 2, 3);
  return XR_SUCCESS;
}
Result XRAPI_CALL resultToString(XrInstance, XrResult result, char* text) {
  std::snprintf(text, XR_MAX_RESULT_STRING_SIZE, "RESULT_%d", static_cast<int>(result));
  return XR_SUCCESS;
}
Result XRAPI_CALL getSystem(XrInstance, const XrSystemGetInfo*, XrSystemId* id) {
  *id = 1;
  return told.hasHeadset ? XR_SUCCESS : XR_ERROR_FORM_FACTOR_UNAVAILABLE;
}
Result XRAPI_CALL systemProperties(XrInstance, XrSystemId, XrSystemProperties* about) {
  std::snprintf(about->systemName, sizeof about->systemName, "A headset of a script");
  if (auto* hands = static_cast<XrSystemHandTrackingPropertiesEXT*>(about->next); hands)
    hands->supportsHandTracking = told.seesHands;
  return XR_SUCCESS;
}
Result XRAPI_CALL enumerateViews(XrInstance, XrSystemId, XrViewConfigurationType, std::uint32_t capacity,
                                 std::uint32_t* count, XrViewConfigurationView* out) {
  XrViewConfigurationView view{
      XR_TYPE_VIEW_CONFIGURATION_VIEW, nullptr, told.size[0], 4096, told.size[1], 4096, 1, 4};
  return give<XrViewConfigurationView>({view, view}, capacity, count, out);
}
Result XRAPI_CALL requirements(XrInstance, XrSystemId, XrGraphicsRequirementsOpenGLKHR* needs) {
  needs->minApiVersionSupported = XR_MAKE_VERSION(3, 2, 0);
  needs->maxApiVersionSupported = XR_MAKE_VERSION(4, 6, 0);
  return XR_SUCCESS;
}
Result XRAPI_CALL createSession(XrInstance, const XrSessionCreateInfo* info, XrSession* out) {
  const auto* binding = static_cast<const XrGraphicsBindingOpenGLXlibKHR*>(info->next);
  if (!binding || binding->type != XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR || !binding->xDisplay ||
      !binding->glxFBConfig || binding->visualid == 0 || binding->glxContext != glXGetCurrentContext())
    return fault("the session has no current context of OpenGL", XR_ERROR_GRAPHICS_DEVICE_INVALID);
  glewExperimental = GL_TRUE;
  glewInit();
  ++told.sessions;
  *out = runtime.session = newHandle<XrSession>();
  told.states.push_back(XR_SESSION_STATE_IDLE);
  told.states.push_back(XR_SESSION_STATE_READY);
  beRude();
  return XR_SUCCESS;
}
Result XRAPI_CALL destroySession(XrSession) { return --told.sessions, XR_SUCCESS; }

Result XRAPI_CALL pollEvent(XrInstance, XrEventDataBuffer* buffer) {
  if (told.recentres) {
    told.recentres = false;
    auto& change = reinterpret_cast<XrEventDataReferenceSpaceChangePending&>(*buffer);
    change = {};
    change.type = XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING;
    change.session = runtime.session;
    change.changeTime = runtime.time + 1;
    return XR_SUCCESS;
  }
  if (told.states.empty()) return XR_EVENT_UNAVAILABLE;
  if (told.states.front() == XR_SESSION_STATE_UNKNOWN) {  // a poll at which nothing happens
    told.states.pop_front();
    return XR_EVENT_UNAVAILABLE;
  }
  auto& change = reinterpret_cast<XrEventDataSessionStateChanged&>(*buffer);
  change = {};
  change.type = XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED;
  change.session = runtime.session;
  change.state = runtime.state = told.states.front();
  change.time = runtime.time;
  told.states.pop_front();
  return XR_SUCCESS;
}
Result XRAPI_CALL beginSession(XrSession, const XrSessionBeginInfo*) {
  if (runtime.state != XR_SESSION_STATE_READY)
    return fault("begun before it is ready", XR_ERROR_SESSION_NOT_READY);
  runtime.isRunning = true;
  for (const XrSessionState state :
       {XR_SESSION_STATE_SYNCHRONIZED, XR_SESSION_STATE_VISIBLE, XR_SESSION_STATE_FOCUSED})
    told.states.push_back(state);
  return XR_SUCCESS;
}
Result XRAPI_CALL endSession(XrSession) {
  if (runtime.state != XR_SESSION_STATE_STOPPING)
    return fault("ended while running", XR_ERROR_SESSION_NOT_STOPPING);
  runtime.isRunning = runtime.isAwaited = runtime.isBegun = false;
  return XR_SUCCESS;
}
Result XRAPI_CALL requestExit(XrSession) {
  if (!runtime.isRunning) return XR_ERROR_SESSION_NOT_RUNNING;
  told.quit();
  return XR_SUCCESS;
}

Result XRAPI_CALL enumerateSpaces(XrSession, std::uint32_t capacity, std::uint32_t* count,
                                  XrReferenceSpaceType* out) {
  std::vector<XrReferenceSpaceType> kinds{XR_REFERENCE_SPACE_TYPE_VIEW, XR_REFERENCE_SPACE_TYPE_LOCAL};
  if (told.hasStage) kinds.push_back(XR_REFERENCE_SPACE_TYPE_STAGE);
  return give(kinds, capacity, count, out);
}
Result XRAPI_CALL createSpace(XrSession, const XrReferenceSpaceCreateInfo* info, XrSpace* out) {
  *out = newHandle<XrSpace>();
  runtime.spaces[*out] = {info->referenceSpaceType, -1, info->poseInReferenceSpace.position.y};
  return ++told.spaces, XR_SUCCESS;
}
Result XRAPI_CALL createActionSpace(XrSession, const XrActionSpaceCreateInfo* info, XrSpace* out) {
  *out = newHandle<XrSpace>();
  const bool isRight = runtime.paths.at(info->subactionPath).find("right") != std::string::npos;
  runtime.spaces[*out] = {XR_REFERENCE_SPACE_TYPE_STAGE, isRight ? 1 : 0, 0.0F};
  return ++told.spaces, XR_SUCCESS;
}
Result XRAPI_CALL destroySpace(XrSpace) { return --told.spaces, XR_SUCCESS; }

Result XRAPI_CALL locateSpace(XrSpace space, XrSpace, XrTime time, XrSpaceLocation* where) {
  if (time != runtime.time)
    return fault("a place is asked for another time than the frame's", XR_ERROR_TIME_INVALID);
  const Space& it = runtime.spaces.at(space);
  if (it.hand >= 0) {
    const XrDoubleHand& hand = runtime.now.hands[static_cast<std::size_t>(it.hand)];
    where->locationFlags = hand.flags;
    where->pose = hand.aim;
    return XR_SUCCESS;
  }
  where->locationFlags = runtime.now.flags;
  where->pose = runtime.now.eyes[0];
  if (auto* velocity = static_cast<XrSpaceVelocity*>(where->next); velocity) {
    velocity->velocityFlags = runtime.now.velocityFlags;
    velocity->linearVelocity = runtime.now.velocity;
  }
  return XR_SUCCESS;
}
Result XRAPI_CALL locateViews(XrSession, const XrViewLocateInfo* info, XrViewState* state,
                              std::uint32_t capacity, std::uint32_t* count, XrView* out) {
  *count = 2;
  if (capacity < 2) return XR_ERROR_SIZE_INSUFFICIENT;
  if (info->displayTime != runtime.time)
    return fault("views are asked for another time than the frame's", XR_ERROR_TIME_INVALID);
  state->viewStateFlags = runtime.now.flags;
  for (std::size_t eye = 0; eye < 2; ++eye) {
    out[eye].pose = runtime.now.eyes[eye];
    out[eye].pose.position.y -= runtime.spaces.at(info->space).height_m;
    out[eye].fov = runtime.now.fov[eye];
  }
  runtime.located_ns = now_ns();
  return XR_SUCCESS;
}

Result XRAPI_CALL enumerateFormats(XrSession, std::uint32_t capacity, std::uint32_t* count,
                                   std::int64_t* out) {
  return give(told.formats, capacity, count, out);
}
Result XRAPI_CALL createChain(XrSession, const XrSwapchainCreateInfo* info, XrSwapchain* out) {
  Chain chain;
  chain.size = {static_cast<int>(info->width), static_cast<int>(info->height)};
  glGenTextures(kImages, chain.textures.data());
  for (const GLuint texture : chain.textures) {
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexStorage2D(GL_TEXTURE_2D, 1, static_cast<GLenum>(info->format), chain.size.x, chain.size.y);
  }
  glBindTexture(GL_TEXTURE_2D, 0);
  *out = newHandle<XrSwapchain>();
  runtime.chains[*out] = chain;
  return ++told.chains, XR_SUCCESS;
}
Result XRAPI_CALL destroyChain(XrSwapchain chain) {
  glDeleteTextures(kImages, runtime.chains.at(chain).textures.data());
  runtime.chains.erase(chain);
  return --told.chains, XR_SUCCESS;
}
Result XRAPI_CALL enumerateImages(XrSwapchain chain, std::uint32_t capacity, std::uint32_t* count,
                                  XrSwapchainImageBaseHeader* out) {
  *count = kImages;
  if (capacity == 0) return XR_SUCCESS;
  auto* images = reinterpret_cast<XrSwapchainImageOpenGLKHR*>(out);
  for (std::size_t i = 0; i < kImages; ++i) images[i].image = runtime.chains.at(chain).textures[i];
  return XR_SUCCESS;
}
Result XRAPI_CALL acquire(XrSwapchain handle, const XrSwapchainImageAcquireInfo*, std::uint32_t* index) {
  Chain& chain = runtime.chains.at(handle);
  if (chain.isAcquired) return fault("an image is acquired twice", XR_ERROR_CALL_ORDER_INVALID);
  *index = static_cast<std::uint32_t>(chain.next);
  chain.isAcquired = true;
  chain.isAwaited = false;
  return XR_SUCCESS;
}
Result XRAPI_CALL waitImage(XrSwapchain handle, const XrSwapchainImageWaitInfo*) {
  Chain& chain = runtime.chains.at(handle);
  if (!chain.isAcquired || chain.isAwaited)
    return fault("an image is awaited that is not acquired", XR_ERROR_CALL_ORDER_INVALID);
  chain.isAwaited = true;
  beRude();
  return XR_SUCCESS;
}
Result XRAPI_CALL release(XrSwapchain handle, const XrSwapchainImageReleaseInfo*) {
  Chain& chain = runtime.chains.at(handle);
  if (!chain.isAwaited) return fault("an image is released that is not awaited", XR_ERROR_CALL_ORDER_INVALID);
  chain.last = std::exchange(chain.next, (chain.next + 1) % kImages);
  chain.isAcquired = chain.isAwaited = false;
  return XR_SUCCESS;
}

Result XRAPI_CALL waitFrame(XrSession, const XrFrameWaitInfo*, XrFrameState* frame) {
  if (!runtime.isRunning) return fault("a frame is awaited while none runs", XR_ERROR_SESSION_NOT_RUNNING);
  if (runtime.isAwaited) return fault("a frame is awaited twice", XR_ERROR_CALL_ORDER_INVALID);
  if (XR_FAILED(told.waitResult)) return told.waitResult;
  runtime.isAwaited = true;
  runtime.now = told.script ? told.script(runtime.frame) : XrDoubleFrame{};
  ++runtime.frame;
  runtime.time += runtime.now.step_ns;
  frame->predictedDisplayTime = runtime.time;
  frame->predictedDisplayPeriod = 11'111'111;
  frame->shouldRender = runtime.now.shouldRender;
  return XR_SUCCESS;
}
Result XRAPI_CALL beginFrame(XrSession, const XrFrameBeginInfo*) {
  if (!std::exchange(runtime.isAwaited, false))
    return fault("a frame begins that was not awaited", XR_ERROR_CALL_ORDER_INVALID);
  if (std::exchange(runtime.isBegun, true)) return fault("a frame was not ended", XR_FRAME_DISCARDED);
  return XR_SUCCESS;
}

/// Returns the bytes of the image that was released last.
std::vector<unsigned char> bytesOf(const Chain& chain) {
  std::vector<unsigned char> rgba(static_cast<std::size_t>(4 * chain.size.x * chain.size.y));
  GLuint buffer = 0;
  glGenFramebuffers(1, &buffer);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, buffer);
  glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, chain.textures[chain.last],
                         0);
  glReadPixels(0, 0, chain.size.x, chain.size.y, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  glDeleteFramebuffers(1, &buffer);
  return rgba;
}

/// Appends a frame to the file of those submitted.
void record(const XrDoubleEnd& end) {
  static const char* const file = std::getenv("CAROM_XR_SEEN");
  if (!file) return;
  std::ofstream out(file, std::ios::binary | std::ios::app);
  const auto put = [&](const auto& value) { out.write(reinterpret_cast<const char*>(&value), sizeof value); };
  const bool whole = end.layers > 0 && told.keepsPictures;
  put(std::int64_t{end.displayTime});
  put(std::int64_t{end.layers});
  float strongest = 0.0F;
  for (const auto& [hand, amplitude] : told.knocks) strongest = std::max(strongest, amplitude);
  told.knocks.clear();
  put(static_cast<std::int64_t>(1000.0F * strongest));
  put(runtime.ours_ns);
  put(runtime.allocated);
  put(std::int64_t{whole});
  for (std::size_t eye = 0; eye < 2 && whole; ++eye) {
    put(end.eyes[eye]);
    put(end.fov[eye]);
    out.write(reinterpret_cast<const char*>(end.rgba[eye].data()),
              static_cast<std::streamsize>(end.rgba[eye].size()));
  }
}

Result XRAPI_CALL endFrame(XrSession, const XrFrameEndInfo* info) {
  if (!std::exchange(runtime.isBegun, false))
    return fault("a frame ends that was not begun", XR_ERROR_CALL_ORDER_INVALID);
  if (info->displayTime != runtime.time)
    return fault("a frame ends with another time than its own", XR_ERROR_TIME_INVALID);
  glFinish();
  runtime.ours_ns = now_ns() - runtime.located_ns;
  runtime.allocated = allocations() - runtime.allocatedBefore;
  XrDoubleEnd end;
  end.displayTime = info->displayTime;
  end.layers = info->layerCount;
  if (info->layerCount > 0) {
    const auto& layer = *reinterpret_cast<const XrCompositionLayerProjection*>(info->layers[0]);
    if (layer.type != XR_TYPE_COMPOSITION_LAYER_PROJECTION || layer.viewCount != 2)
      return fault("a layer is not the picture of two eyes", XR_ERROR_LAYER_INVALID);
    for (std::size_t eye = 0; eye < 2; ++eye) {
      end.eyes[eye] = layer.views[eye].pose;
      end.fov[eye] = layer.views[eye].fov;
      const Chain& chain = runtime.chains.at(layer.views[eye].subImage.swapchain);
      if (chain.isAcquired)
        return fault("an image is shown that is not released", XR_ERROR_VALIDATION_FAILURE);
      if (told.keepsPictures) end.rgba[eye] = bytesOf(chain);
    }
  }
  record(end);
  told.ends.push_back(std::move(end));
  beRude();
  runtime.allocatedBefore = allocations();
  return XR_SUCCESS;
}

Result XRAPI_CALL stringToPath(XrInstance, const char* text, XrPath* path) {
  const auto found = std::find(runtime.paths.begin() + 1, runtime.paths.end(), text);
  *path = static_cast<XrPath>(found - runtime.paths.begin());
  if (found == runtime.paths.end()) runtime.paths.emplace_back(text);
  return XR_SUCCESS;
}
Result XRAPI_CALL createActionSet(XrInstance, const XrActionSetCreateInfo*, XrActionSet* out) {
  return *out = newHandle<XrActionSet>(), XR_SUCCESS;
}
Result XRAPI_CALL destroyActionSet(XrActionSet) { return XR_SUCCESS; }
Result XRAPI_CALL createAction(XrActionSet, const XrActionCreateInfo* info, XrAction* out) {
  *out = newHandle<XrAction>();
  runtime.actions[*out] = info->actionName;
  return XR_SUCCESS;
}
Result XRAPI_CALL suggest(XrInstance, const XrInteractionProfileSuggestedBinding*) {
  return told.hasHandProfile ? XR_SUCCESS : XR_ERROR_PATH_UNSUPPORTED;
}
Result XRAPI_CALL attach(XrSession, const XrSessionActionSetsAttachInfo*) { return XR_SUCCESS; }
Result XRAPI_CALL syncActions(XrSession, const XrActionsSyncInfo*) {
  return runtime.state == XR_SESSION_STATE_FOCUSED ? XR_SUCCESS : XR_SESSION_NOT_FOCUSED;
}
const XrDoubleHand& handOf(const XrActionStateGetInfo* info) {
  return runtime.now.hands[runtime.paths.at(info->subactionPath).find("right") != std::string::npos];
}
Result XRAPI_CALL stateBoolean(XrSession, const XrActionStateGetInfo* info, XrActionStateBoolean* state) {
  const std::string& name = runtime.actions.at(info->action);
  const XrDoubleHand& hand = handOf(info);
  state->isActive = name != "select";
  state->currentState = name == "first"    ? hand.first
                        : name == "second" ? hand.second
                                           : name == "menu" && hand.menu;
  return XR_SUCCESS;
}
Result XRAPI_CALL stateFloat(XrSession, const XrActionStateGetInfo* info, XrActionStateFloat* state) {
  state->isActive = XR_TRUE;
  state->currentState = handOf(info).trigger;
  return XR_SUCCESS;
}
Result XRAPI_CALL stateVector(XrSession, const XrActionStateGetInfo* info, XrActionStateVector2f* state) {
  state->isActive = XR_TRUE;
  state->currentState = handOf(info).stick;
  return XR_SUCCESS;
}
Result XRAPI_CALL haptic(XrSession, const XrHapticActionInfo* info, const XrHapticBaseHeader* feedback) {
  const bool isRight = runtime.paths.at(info->subactionPath).find("right") != std::string::npos;
  told.knocks.emplace_back(isRight, reinterpret_cast<const XrHapticVibration*>(feedback)->amplitude);
  return XR_SUCCESS;
}
Result XRAPI_CALL createHandTracker(XrSession, const XrHandTrackerCreateInfoEXT* info,
                                    XrHandTrackerEXT* out) {
  // The handle says which hand it is.
  *out = reinterpret_cast<XrHandTrackerEXT>(info->hand == XR_HAND_RIGHT_EXT ? std::uintptr_t{2} : 1);
  return ++told.handTrackers, XR_SUCCESS;
}
Result XRAPI_CALL destroyHandTracker(XrHandTrackerEXT) { return --told.handTrackers, XR_SUCCESS; }
Result XRAPI_CALL locateHandJoints(XrHandTrackerEXT tracker, const XrHandJointsLocateInfoEXT* info,
                                   XrHandJointLocationsEXT* out) {
  if (info->time != runtime.time)
    return fault("joints are asked for another time than the frame's", XR_ERROR_TIME_INVALID);
  if (out->jointCount != XR_HAND_JOINT_COUNT_EXT)
    return fault("a hand has other joints", XR_ERROR_VALIDATION_FAILURE);
  const XrDoubleHand& hand = runtime.now.hands[reinterpret_cast<std::uintptr_t>(tracker) - 1];
  out->isActive = hand.tipsApart_m >= 0.0F;
  for (std::uint32_t joint = 0; joint < out->jointCount; ++joint) {
    out->jointLocations[joint] = {};
    out->jointLocations[joint].locationFlags = out->isActive ? 15 : 0;
    out->jointLocations[joint].pose = hand.aim;
  }
  out->jointLocations[XR_HAND_JOINT_INDEX_TIP_EXT].pose.position.y += hand.tipsApart_m;
  return XR_SUCCESS;
}
Result XRAPI_CALL unsupported() { return XR_ERROR_FUNCTION_UNSUPPORTED; }

Result XRAPI_CALL procAddress(XrInstance, const char* name, PFN_xrVoidFunction* out) {
#define CAROM_XR(name, function) \
  { name, reinterpret_cast<PFN_xrVoidFunction>(function) }
  static const std::map<std::string, PFN_xrVoidFunction> kAll = {
      CAROM_XR("xrGetInstanceProcAddr", procAddress),
      CAROM_XR("xrEnumerateInstanceExtensionProperties", enumerateExtensions),
      CAROM_XR("xrCreateInstance", createInstance),
      CAROM_XR("xrDestroyInstance", destroyInstance),
      CAROM_XR("xrGetInstanceProperties", instanceProperties),
      CAROM_XR("xrResultToString", resultToString),
      CAROM_XR("xrGetSystem", getSystem),
      CAROM_XR("xrGetSystemProperties", systemProperties),
      CAROM_XR("xrEnumerateViewConfigurationViews", enumerateViews),
      CAROM_XR("xrGetOpenGLGraphicsRequirementsKHR", requirements),
      CAROM_XR("xrCreateSession", createSession),
      CAROM_XR("xrDestroySession", destroySession),
      CAROM_XR("xrPollEvent", pollEvent),
      CAROM_XR("xrBeginSession", beginSession),
      CAROM_XR("xrEndSession", endSession),
      CAROM_XR("xrRequestExitSession", requestExit),
      CAROM_XR("xrEnumerateReferenceSpaces", enumerateSpaces),
      CAROM_XR("xrCreateReferenceSpace", createSpace),
      CAROM_XR("xrCreateActionSpace", createActionSpace),
      CAROM_XR("xrDestroySpace", destroySpace),
      CAROM_XR("xrLocateSpace", locateSpace),
      CAROM_XR("xrLocateViews", locateViews),
      CAROM_XR("xrEnumerateSwapchainFormats", enumerateFormats),
      CAROM_XR("xrCreateSwapchain", createChain),
      CAROM_XR("xrDestroySwapchain", destroyChain),
      CAROM_XR("xrEnumerateSwapchainImages", enumerateImages),
      CAROM_XR("xrAcquireSwapchainImage", acquire),
      CAROM_XR("xrWaitSwapchainImage", waitImage),
      CAROM_XR("xrReleaseSwapchainImage", release),
      CAROM_XR("xrWaitFrame", waitFrame),
      CAROM_XR("xrBeginFrame", beginFrame),
      CAROM_XR("xrEndFrame", endFrame),
      CAROM_XR("xrStringToPath", stringToPath),
      CAROM_XR("xrCreateActionSet", createActionSet),
      CAROM_XR("xrDestroyActionSet", destroyActionSet),
      CAROM_XR("xrCreateAction", createAction),
      CAROM_XR("xrSuggestInteractionProfileBindings", suggest),
      CAROM_XR("xrAttachSessionActionSets", attach),
      CAROM_XR("xrSyncActions", syncActions),
      CAROM_XR("xrGetActionStateBoolean", stateBoolean),
      CAROM_XR("xrGetActionStateFloat", stateFloat),
      CAROM_XR("xrGetActionStateVector2f", stateVector),
      CAROM_XR("xrApplyHapticFeedback", haptic),
      CAROM_XR("xrCreateHandTrackerEXT", createHandTracker),
      CAROM_XR("xrDestroyHandTrackerEXT", destroyHandTracker),
      CAROM_XR("xrLocateHandJointsEXT", locateHandJoints)};
#undef CAROM_XR
  const auto found = kAll.find(name);
  // The loader calls what is missing through a null pointer, so nothing of OpenXR 1.0 may be missing.
  *out = found == kAll.end() ? reinterpret_cast<PFN_xrVoidFunction>(unsupported) : found->second;
  return XR_SUCCESS;
}

}  // namespace

}  // namespace carom::test

extern "C" {
__attribute__((visibility("default"))) carom::test::XrDouble* caromXrDouble(bool anew) {
  if (anew) carom::test::told = {};
  return &carom::test::told;
}

__attribute__((visibility("default"))) XrResult xrNegotiateLoaderRuntimeInterface(
    const XrNegotiateLoaderInfo* loader, XrNegotiateRuntimeRequest* request) {
  if (!loader || !request || loader->minInterfaceVersion > 1 || loader->maxInterfaceVersion < 1)
    return XR_ERROR_INITIALIZATION_FAILED;
  carom::test::takeHabits();
  request->runtimeInterfaceVersion = 1;
  request->runtimeApiVersion = XR_MAKE_VERSION(1, 0, 20);
  request->getInstanceProcAddr = carom::test::procAddress;
  return XR_SUCCESS;
}
}
