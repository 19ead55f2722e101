#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdlib>
#include <string>

#include "src/render/gl/context.h"
#include "src/render/gl/shared_library.h"

namespace tumble::render {
namespace {

constexpr std::array kEglNames = {"libEGL.so.1", "libEGL.so"};

constexpr std::array<EGLint, 5> kConfigAttributes = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                                     EGL_OPENGL_BIT, EGL_NONE};
constexpr std::array<EGLint, 7> kContextAttributes = {
    EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
    EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};

// The entry points of libEGL that are needed, by their own types.
struct Egl {
  decltype(&eglGetProcAddress) get_proc = nullptr;
  decltype(&eglInitialize) initialize = nullptr;
  decltype(&eglBindAPI) bind_api = nullptr;
  decltype(&eglChooseConfig) choose_config = nullptr;
  decltype(&eglCreateContext) create_context = nullptr;
  decltype(&eglMakeCurrent) make_current = nullptr;
  decltype(&eglDestroyContext) destroy_context = nullptr;
  decltype(&eglTerminate) terminate = nullptr;
  PFNEGLGETPLATFORMDISPLAYEXTPROC get_display = nullptr;

  explicit Egl(const SharedLibrary& library)
      : get_proc(library.find<decltype(get_proc)>("eglGetProcAddress")),
        initialize(library.find<decltype(initialize)>("eglInitialize")),
        bind_api(library.find<decltype(bind_api)>("eglBindAPI")),
        choose_config(library.find<decltype(choose_config)>("eglChooseConfig")),
        create_context(library.find<decltype(create_context)>("eglCreateContext")),
        make_current(library.find<decltype(make_current)>("eglMakeCurrent")),
        destroy_context(library.find<decltype(destroy_context)>("eglDestroyContext")),
        terminate(library.find<decltype(terminate)>("eglTerminate")) {
    if (get_proc != nullptr) {
      get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(get_proc("eglGetPlatformDisplayEXT"));
    }
  }
  [[nodiscard]] bool complete() const {
    return get_proc != nullptr && initialize != nullptr && bind_api != nullptr && choose_config != nullptr &&
           create_context != nullptr && make_current != nullptr && destroy_context != nullptr && terminate != nullptr &&
           get_display != nullptr;
  }
};

class EglContext : public Context {
 public:
  explicit EglContext(const SharedLibrary& library) : Context("EGL"), egl_(library) {}
  ~EglContext() override {
    if (display_ == EGL_NO_DISPLAY) return;
    egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (handle_ != EGL_NO_CONTEXT) egl_.destroy_context(display_, handle_);
    egl_.terminate(display_);
  }

  Status start() {
    if (!egl_.complete()) return cannot_finish("EGL: the library lacks what EGL 1.5 with platforms has");
    // A graphics card would give other bits than the processor; Mesa reads this when the display is opened.
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 0);
    display_ = egl_.get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || egl_.initialize(display_, nullptr, nullptr) == EGL_FALSE) {
      display_ = EGL_NO_DISPLAY;
      return cannot_finish("EGL: no display without a surface (is Mesa's driver, libgl1-mesa-dri, installed?)");
    }
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (egl_.bind_api(EGL_OPENGL_API) == EGL_FALSE ||
        egl_.choose_config(display_, kConfigAttributes.data(), &config, 1, &count) == EGL_FALSE || count == 0) {
      return cannot_finish("EGL: no configuration for OpenGL");
    }
    handle_ = egl_.create_context(display_, config, EGL_NO_CONTEXT, kContextAttributes.data());
    if (handle_ == EGL_NO_CONTEXT) return cannot_finish("EGL: no context of OpenGL 3.3 core");
    if (egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, handle_) == EGL_FALSE) {
      return cannot_finish("EGL: the context cannot be made current without a surface");
    }
    get_proc_ = egl_.get_proc;
    return load([](const char* name) { return get_proc_(name); });
  }

 private:
  static inline decltype(&eglGetProcAddress) get_proc_ = nullptr;
  Egl egl_;
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext handle_ = EGL_NO_CONTEXT;
};

}  // namespace

Result<std::unique_ptr<Context>> open_egl() {
  const Result<SharedLibrary> library = SharedLibrary::load(kEglNames);
  if (!library.ok()) return cannot_finish("EGL: " + library.error().message);
  auto context = std::make_unique<EglContext>(*library);
  const Status started = context->start();
  if (!started.ok()) return started.error();
  return std::unique_ptr<Context>(std::move(context));
}

}  // namespace tumble::render
