#include <array>
#include <vector>

#include "src/render/gl/context.h"
#include "src/render/gl/shared_library.h"

namespace tumble::render {
namespace {

constexpr std::array kOsMesaNames = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};

// Never shown: every pass draws into framebuffers of its own.
constexpr int kDummySize = 16;

// From GL/osmesa.h, which cannot be included beside glcorearb.h.
constexpr int kFormat = 0x22, kRgba = GL_RGBA;
constexpr int kDepthBits = 0x30, kStencilBits = 0x31, kAccumBits = 0x32;
constexpr int kProfile = 0x33, kCoreProfile = 0x34;
constexpr int kMajorVersion = 0x36, kMinorVersion = 0x37;

constexpr std::array<int, 15> kAttributes = {kFormat,  kRgba,        kDepthBits,    0, kStencilBits,  0, kAccumBits, 0,
                                             kProfile, kCoreProfile, kMajorVersion, 3, kMinorVersion, 3, 0};

struct OsmesaState;  // opaque
using OSMesaContext = OsmesaState*;
using CreateContext = OSMesaContext (*)(const int*, OSMesaContext);
using DestroyContext = void (*)(OSMesaContext);
using MakeCurrent = GLboolean (*)(OSMesaContext, void*, GLenum, GLsizei, GLsizei);
using GetProc = GlFunction (*)(const char*);

class OsmesaContext : public Context {
 public:
  OsmesaContext() : Context("OSMesa"), dummy_(std::size_t{kDummySize} * kDummySize * 4) {}
  ~OsmesaContext() override {
    if (handle_ != nullptr) destroy_(handle_);
  }

  Status start(const SharedLibrary& library) {
    const auto create = library.find<CreateContext>("OSMesaCreateContextAttribs");
    const auto make_current = library.find<MakeCurrent>("OSMesaMakeCurrent");
    destroy_ = library.find<DestroyContext>("OSMesaDestroyContext");
    get_proc_ = library.find<GetProc>("OSMesaGetProcAddress");
    if (create == nullptr || make_current == nullptr || destroy_ == nullptr || get_proc_ == nullptr) {
      return cannot_finish("OSMesa: the library is too old: wanted OSMesaCreateContextAttribs (Mesa 11.2 or newer)");
    }
    handle_ = create(kAttributes.data(), nullptr);
    if (handle_ == nullptr) return cannot_finish("OSMesa: no context of OpenGL 3.3 core");
    if (make_current(handle_, dummy_.data(), GL_UNSIGNED_BYTE, kDummySize, kDummySize) == GL_FALSE) {
      return cannot_finish("OSMesa: the context cannot be made current");
    }
    return load([](const char* name) { return get_proc_(name); });
  }

 private:
  static inline GetProc get_proc_ = nullptr;
  DestroyContext destroy_ = nullptr;
  OSMesaContext handle_ = nullptr;
  std::vector<unsigned char> dummy_;
};

}  // namespace

Result<std::unique_ptr<Context>> open_osmesa() {
  const Result<SharedLibrary> library = SharedLibrary::load(kOsMesaNames);
  if (!library.ok()) return cannot_finish("OSMesa: " + library.error().message);
  auto context = std::make_unique<OsmesaContext>();
  const Status started = context->start(*library);
  if (!started.ok()) return started.error();
  return std::unique_ptr<Context>(std::move(context));
}

}  // namespace tumble::render
