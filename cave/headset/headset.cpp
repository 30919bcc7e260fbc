#include "cave/headset/headset.h"

#include <GL/glew.h>
#define GLFW_EXPOSE_NATIVE_X11
#define GLFW_EXPOSE_NATIVE_GLX
#include <GLFW/glfw3.h>
#include <GLFW/glfw3native.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "cave/headset/eye_images.h"
#include "cave/headset/hand_actions.h"
#include "cave/headset/instance.h"
#include "cave/headset/openxr.h"

namespace carom {
namespace {

using namespace openxr;

constexpr double kStandingEyes_m = 1.7;  // above the floor, where the runtime knows no floor
constexpr double kHalfSeparation_m = 0.032;
constexpr const char* kLost = "the headset is lost";

/// The session of a headset, on the drawing context.
class OwnedSession {
 public:
  OwnedSession(const Instance& instance, XrSystemId system, const Graphics& graphics) {
    auto needs = infoOf<XrGraphicsRequirementsOpenGLKHR>(XR_TYPE_GRAPHICS_REQUIREMENTS_OPENGL_KHR);
    const auto ask =
        entry<PFN_xrGetOpenGLGraphicsRequirementsKHR>(instance, "xrGetOpenGLGraphicsRequirementsKHR");
    check(instance, ask ? ask(instance, system, &needs) : XR_ERROR_FUNCTION_UNSUPPORTED,
          "the headset's runtime does not say which OpenGL it needs");
    graphics.makeCurrent();
    const XrGraphicsBindingOpenGLXlibKHR binding = bindingOf(graphics);
    auto create = infoOf<XrSessionCreateInfo>(XR_TYPE_SESSION_CREATE_INFO);
    create.next = &binding;
    create.systemId = system;
    const XrResult result = xrCreateSession(instance, &create, &handle_);
    takeBack(graphics);
    check(instance, result, "the headset's runtime does not let this program draw");
  }
  ~OwnedSession() { xrDestroySession(handle_); }
  OwnedSession(const OwnedSession&) = delete;
  OwnedSession& operator=(const OwnedSession&) = delete;

  operator XrSession() const { return handle_; }

 private:
  static XrGraphicsBindingOpenGLXlibKHR bindingOf(const Graphics& graphics) {
    Display* display = glfwGetX11Display();
    auto binding = infoOf<XrGraphicsBindingOpenGLXlibKHR>(XR_TYPE_GRAPHICS_BINDING_OPENGL_XLIB_KHR);
    binding.xDisplay = display;
    binding.glxContext = glfwGetGLXContext(graphics.context());
    binding.glxDrawable = glfwGetGLXWindow(graphics.context());
    int id = 0, found = 0, visual = 0;
    glXQueryContext(display, binding.glxContext, GLX_FBCONFIG_ID, &id);
    const std::array<int, 3> asked = {GLX_FBCONFIG_ID, id, None};
    GLXFBConfig* configs = glXChooseFBConfig(display, DefaultScreen(display), asked.data(), &found);
    if (found > 0) {
      glXGetFBConfigAttrib(display, configs[0], GLX_VISUAL_ID, &visual);
      binding.glxFBConfig = configs[0];
      binding.visualid = static_cast<std::uint32_t>(visual);
    }
    XFree(configs);
    return binding;
  }

  XrSession handle_ = XR_NULL_HANDLE;
};

/// Returns what a view says, if its numbers can be those of an eye.
std::optional<HeadsetEye> eyeOf(const XrView& view) {
  const XrFovf& fov = view.fov;
  const XrPosef& pose = view.pose;
  const double norm = std::hypot(std::hypot(pose.orientation.x, pose.orientation.y),
                                 std::hypot(pose.orientation.z, pose.orientation.w));
  const double away = std::hypot(pose.position.x, pose.position.y, pose.position.z);
  const auto isAngle = [](double angle) { return std::abs(angle) < 1.55; };  // 89°
  const bool isWhole = norm > 0.5 && norm < 2.0 && away < 1e4 && isAngle(fov.angleLeft) &&
                       isAngle(fov.angleRight) && isAngle(fov.angleDown) && isAngle(fov.angleUp) &&
                       fov.angleLeft < fov.angleRight && fov.angleDown < fov.angleUp;
  if (!isWhole) return {};
  const auto tangent = [](float angle) { return std::tan(static_cast<double>(angle)); };
  return HeadsetEye{
      poseOf(pose),
      {tangent(fov.angleLeft), tangent(fov.angleRight), tangent(fov.angleDown), tangent(fov.angleUp)}};
}

}  // namespace

struct Headset::Session {
  explicit Session(const Graphics& drawing)
      : graphics(drawing),
        system(instance.system()),
        runtime(instance.runtime()),
        name(instance.nameOf(system)),
        pixels(instance.recommendedPixels(system)),
        handle(instance, system, drawing),
        hands(instance, handle, instance.followsHands(system)),
        images{{{instance, handle, pixels}, {instance, handle, pixels}}} {
    const auto kinds = listOf(XR_REFERENCE_SPACE_TYPE_LOCAL,
                              [&](std::uint32_t capacity, std::uint32_t* count, XrReferenceSpaceType* items) {
                                return xrEnumerateReferenceSpaces(handle, capacity, count, items);
                              });
    hasFloor = std::find(kinds.begin(), kinds.end(), XR_REFERENCE_SPACE_TYPE_STAGE) != kinds.end();
    // The origin of the local space is where the eyes were when it was last centred.
    room = hasFloor ? space(XR_REFERENCE_SPACE_TYPE_STAGE, 0.0)
                    : space(XR_REFERENCE_SPACE_TYPE_LOCAL, -kStandingEyes_m);
    head = space(XR_REFERENCE_SPACE_TYPE_VIEW, 0.0);
    takeBack(graphics);
  }

  XrSpace space(XrReferenceSpaceType kind, double height_m) {
    auto info = infoOf<XrReferenceSpaceCreateInfo>(XR_TYPE_REFERENCE_SPACE_CREATE_INFO);
    info.referenceSpaceType = kind;
    info.poseInReferenceSpace.orientation.w = 1.0F;
    info.poseInReferenceSpace.position.y = static_cast<float>(height_m);
    XrSpace made = XR_NULL_HANDLE;
    check(instance, xrCreateReferenceSpace(handle, &info, &made), "the headset's runtime knows no room");
    return made;
  }

  void take(const XrEventDataBuffer& event);
  void changeTo(XrSessionState next);
  void placeWithout(std::array<XrView, 2>& located) const;
  void locate(HeadsetFrame& frame);
  void end(bool withPictures);

  const Graphics& graphics;
  Instance instance;
  XrSystemId system;
  std::string runtime, name;
  glm::ivec2 pixels;
  OwnedSession handle;
  HandActions hands;
  std::array<EyeImages, 2> images;
  bool hasFloor = false;
  XrSpace room = XR_NULL_HANDLE, head = XR_NULL_HANDLE;

  State state = State::idle;
  bool isBegun = false;    // a frame, which must be ended
  std::size_t aiming = 1;  ///< the hand that holds or aims the cue
  std::string whyEnded;
  XrTime recentredFrom = 0;  // 0: not since the last frame
  XrFrameState waited = infoOf<XrFrameState>(XR_TYPE_FRAME_STATE);
  std::array<XrView, 2> views{};   // as they were last known,
  std::array<HeadsetEye, 2> eyes;  // and the same in our terms
  bool isKnown = false;            // they have been known once

  void endFor(const char* why) {
    state = State::ended;
    whyEnded = why;
  }
};

void Headset::Session::changeTo(XrSessionState next) {
  switch (next) {
    case XR_SESSION_STATE_READY: {
      auto begin = infoOf<XrSessionBeginInfo>(XR_TYPE_SESSION_BEGIN_INFO);
      begin.primaryViewConfigurationType = kStereo;
      check(instance, xrBeginSession(handle, &begin), "the headset's session does not begin");
      state = State::running;
      break;
    }
    case XR_SESSION_STATE_STOPPING:
      xrEndSession(handle);
      state = State::idle;
      break;
    case XR_SESSION_STATE_EXITING:
      endFor("the headset's system has ended the session");
      break;
    case XR_SESSION_STATE_LOSS_PENDING:
      endFor(kLost);
      break;
    default:  // synchronised, visible, focused: frames say whether they are seen, and hands whether they act
      break;
  }
}

void Headset::Session::take(const XrEventDataBuffer& event) {
  if (event.type == XR_TYPE_EVENT_DATA_SESSION_STATE_CHANGED)
    changeTo(reinterpret_cast<const XrEventDataSessionStateChanged&>(event).state);
  if (event.type == XR_TYPE_EVENT_DATA_INSTANCE_LOSS_PENDING) endFor(kLost);
  if (event.type == XR_TYPE_EVENT_DATA_REFERENCE_SPACE_CHANGE_PENDING)
    recentredFrom = std::max<XrTime>(
        1, reinterpret_cast<const XrEventDataReferenceSpaceChangePending&>(event).changeTime);
}

/// Gives the eyes of a headset that knows directions alone the places that they had, or those of somebody who
/// stands.
void Headset::Session::placeWithout(std::array<XrView, 2>& located) const {
  const glm::dvec3 middle_m = isKnown ? headBetween(eyes).position_m : glm::dvec3(0.0, kStandingEyes_m, 0.0);
  for (std::size_t eye = 0; eye < 2; ++eye) {
    const glm::dquat attitude = poseOf(located[eye].pose).orientation;
    const glm::vec3 place_m =
        middle_m + attitude * glm::dvec3(eye == 0 ? -kHalfSeparation_m : kHalfSeparation_m, 0.0, 0.0);
    located[eye].pose.position = {place_m.x, place_m.y, place_m.z};
  }
}

/// Locates eyes, head and hands for the moment of the frame's display.
void Headset::Session::locate(HeadsetFrame& frame) {
  auto where = infoOf<XrViewLocateInfo>(XR_TYPE_VIEW_LOCATE_INFO);
  where.viewConfigurationType = kStereo;
  where.displayTime = waited.predictedDisplayTime;
  where.space = room;
  auto found = infoOf<XrViewState>(XR_TYPE_VIEW_STATE);
  std::uint32_t count = 0;
  std::array<XrView, 2> located{infoOf<XrView>(XR_TYPE_VIEW), infoOf<XrView>(XR_TYPE_VIEW)};
  const bool isLocated = XR_SUCCEEDED(xrLocateViews(handle, &where, &found, 2, &count, located.data())) &&
                         count == 2 && (found.viewStateFlags & XR_VIEW_STATE_ORIENTATION_VALID_BIT);
  frame.hasPosition = isLocated && (found.viewStateFlags & XR_VIEW_STATE_POSITION_VALID_BIT);
  if (isLocated && !frame.hasPosition) placeWithout(located);
  const auto left = eyeOf(located[0]), right = eyeOf(located[1]);
  frame.isTracked = isLocated && left && right;
  if (frame.isTracked) {
    views = located;
    eyes = {*left, *right};
    isKnown = true;
  }
  frame.eyes = eyes;

  auto motion = infoOf<XrSpaceVelocity>(XR_TYPE_SPACE_VELOCITY);
  auto place = infoOf<XrSpaceLocation>(XR_TYPE_SPACE_LOCATION);
  place.next = &motion;
  if (XR_SUCCEEDED(xrLocateSpace(head, room, waited.predictedDisplayTime, &place)) &&
      (motion.velocityFlags & XR_SPACE_VELOCITY_LINEAR_VALID_BIT))
    frame.runtimeVelocity_m_s = {motion.linearVelocity.x, motion.linearVelocity.y, motion.linearVelocity.z};
  frame.hands = hands.at(waited.predictedDisplayTime, room);
}

/// Ends the frame: with the eyes' pictures at the places for which they were drawn, or with nothing.
void Headset::Session::end(bool withPictures) {
  std::array<XrCompositionLayerProjectionView, 2> drawn{};
  for (std::size_t eye = 0; eye < 2; ++eye) {
    drawn[eye].type = XR_TYPE_COMPOSITION_LAYER_PROJECTION_VIEW;
    drawn[eye].pose = views[eye].pose;
    drawn[eye].fov = views[eye].fov;
    drawn[eye].subImage = images[eye].subImage();
  }
  auto layer = infoOf<XrCompositionLayerProjection>(XR_TYPE_COMPOSITION_LAYER_PROJECTION);
  layer.space = room;
  layer.viewCount = 2;
  layer.views = drawn.data();
  const auto* layers = reinterpret_cast<const XrCompositionLayerBaseHeader*>(&layer);
  auto end = infoOf<XrFrameEndInfo>(XR_TYPE_FRAME_END_INFO);
  end.displayTime = waited.predictedDisplayTime;
  end.environmentBlendMode = XR_ENVIRONMENT_BLEND_MODE_OPAQUE;
  end.layerCount = withPictures ? 1 : 0;
  end.layers = &layers;
  const XrResult result = xrEndFrame(handle, &end);
  takeBack(graphics);
  if (result == XR_ERROR_SESSION_LOST || result == XR_ERROR_INSTANCE_LOST) endFor(kLost);
}

Headset::Headset(const Graphics& graphics) : session_(std::make_unique<Session>(graphics)) {}
Headset::~Headset() = default;

Headset::State Headset::state() const { return session_->state; }

Headset::State Headset::poll() {
  auto event = infoOf<XrEventDataBuffer>(XR_TYPE_EVENT_DATA_BUFFER);
  while (xrPollEvent(session_->instance, &event) == XR_SUCCESS) {
    session_->take(event);
    event = infoOf<XrEventDataBuffer>(XR_TYPE_EVENT_DATA_BUFFER);
  }
  return session_->state;
}

std::optional<HeadsetFrame> Headset::nextFrame() {
  Session& session = *session_;
  if (session.state != State::running) return {};
  const XrResult result = xrWaitFrame(session.handle, nullptr, &session.waited);
  takeBack(session.graphics);
  if (XR_FAILED(result) || XR_FAILED(xrBeginFrame(session.handle, nullptr))) {
    session.endFor(kLost);
    return {};
  }
  session.isBegun = true;
  HeadsetFrame frame;
  frame.display_ns = session.waited.predictedDisplayTime;
  frame.untilNext_ns = session.waited.predictedDisplayPeriod;
  frame.isSeen = session.waited.shouldRender == XR_TRUE;
  frame.isRecentred =
      session.recentredFrom != 0 && session.waited.predictedDisplayTime >= session.recentredFrom;
  if (frame.isRecentred) session.recentredFrom = 0;
  session.locate(frame);
  frame.aiming = session.aiming = aimingHand(session.aiming, frame.hands);
  return frame;
}

void Headset::submit(const std::array<unsigned, 2>* pictures) {
  Session& session = *session_;
  if (!std::exchange(session.isBegun, false)) return;
  bool all = pictures != nullptr && session.isKnown && session.waited.shouldRender == XR_TRUE;
  for (std::size_t eye = 0; eye < 2 && all; ++eye)
    all = session.images[eye].fill(session.graphics, (*pictures)[eye]);
  session.end(all);
}

void Headset::knock(double strength, double duration_s) {
  session_->hands.knock(static_cast<int>(session_->aiming), strength, duration_s);
}

void Headset::askToEnd() {
  if (XR_FAILED(xrRequestExitSession(session_->handle))) session_->endFor(kLost);
}

glm::ivec2 Headset::pixels() const { return session_->pixels; }
const std::string& Headset::runtime() const { return session_->runtime; }
const std::string& Headset::system() const { return session_->name; }
bool Headset::hasFloor() const { return session_->hasFloor; }
bool Headset::takesEncoded() const { return session_->images[0].isEncoded(); }
const std::string& Headset::whyEnded() const { return session_->whyEnded; }

std::string aboutHeadsets() try {
  const Instance instance;
  const std::string runtime = instance.runtime();
  try {
    return fmt::format("{}, by {}", instance.nameOf(instance.system()), runtime);
  } catch (const std::exception& error) {
    return fmt::format("{}; the runtime is {}", error.what(), runtime);
  }
} catch (const std::exception& error) {
  return error.what();
}

}  // namespace carom
