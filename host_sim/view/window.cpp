#include "view/window.hpp"

#include <algorithm>

#include "base/failure.hpp"

namespace spanline::sim {
namespace {

/// Windows are about this wide, by whole multiples of the picture.
constexpr int wanted_width = 960;

template <class Pointer>
Pointer* check(Pointer* pointer) {
  if (pointer == nullptr) throw Failure(std::string("no window: ") + SDL_GetError());
  return pointer;
}

void check(int result) {
  if (result != 0) throw Failure(std::string("window: ") + SDL_GetError());
}

}  // namespace

Window::Library::Library() {
  if (SDL_Init(SDL_INIT_VIDEO) != 0) throw Failure(std::string("no window: ") + SDL_GetError());
}

Window::Window(const std::string& title, Size size) : size_(size) {
  const int factor = std::max(1, wanted_width / size.width);
  window_.reset(check(SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED,
                                       size.width * factor, size.height * factor, SDL_WINDOW_RESIZABLE)));
  renderer_.reset(check(SDL_CreateRenderer(window_.get(), -1, 0)));
  check(SDL_RenderSetLogicalSize(renderer_.get(), size.width, size.height));
  texture_.reset(check(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_RGB565, SDL_TEXTUREACCESS_STREAMING,
                                         size.width, size.height)));
}

void Window::show(const std::vector<std::uint16_t>& pixels) {
  check(SDL_UpdateTexture(texture_.get(), nullptr, pixels.data(), size_.width * 2));
  draw();
  SDL_RenderPresent(renderer_.get());
}

void Window::draw() {
  check(SDL_RenderClear(renderer_.get()));
  check(SDL_RenderCopy(renderer_.get(), texture_.get(), nullptr, nullptr));
}

Picture Window::read_back() {
  draw();  // after SDL_RenderPresent the back buffer's content is undefined
  int width = 0, height = 0;
  check(SDL_GetRendererOutputSize(renderer_.get(), &width, &height));
  Picture picture(width, height);
  check(SDL_RenderReadPixels(renderer_.get(), nullptr, SDL_PIXELFORMAT_RGB24, picture.pixels.data(), width * 3));
  return picture;
}

}  // namespace spanline::sim
