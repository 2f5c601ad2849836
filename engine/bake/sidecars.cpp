#include "engine/bake/sidecars.hpp"

namespace windloom {

Result<std::vector<BakedFile>> writeSidecars(const Project&, const BakeHeader&, std::span<const BakedFile>,
                                             const std::filesystem::path&) {
  return std::vector<BakedFile>{};
}

}  // namespace windloom
