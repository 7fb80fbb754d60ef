#pragma once
#include <SDL.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/parse.hpp"
#include "image/picture.hpp"

namespace spanline::sim {

/// An SDL window that shows RGB565 pictures of one size, enlarged. Throws Failure if SDL has no window to give.
class Window {
 public:
  Window(const std::string& title, Size size);

  void set_title(const std::string& title) { SDL_SetWindowTitle(window_.get(), title.c_str()); }
  void show(const std::vector<std::uint16_t>& pixels);
  /// What the window shows, as SDL reads it back.
  [[nodiscard]] Picture read_back();

 private:
  struct Library {
    Library();
    ~Library() { SDL_Quit(); }
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
  };
  struct Release {
    void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
    void operator()(SDL_Renderer* renderer) const { SDL_DestroyRenderer(renderer); }
    void operator()(SDL_Texture* texture) const { SDL_DestroyTexture(texture); }
  };

  void draw();

  Library library_;
  Size size_;
  std::unique_ptr<SDL_Window, Release> window_;
  std::unique_ptr<SDL_Renderer, Release> renderer_;
  std::unique_ptr<SDL_Texture, Release> texture_;
};

}  // namespace spanline::sim
