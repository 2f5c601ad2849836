#include "engine/gpu/readback.hpp"

#include <string>

#include "engine/gpu/context.hpp"
#include "engine/gpu/memory_failure.hpp"
#include "engine/gpu/object_label.hpp"

namespace windloom::gpu {

Result<ReadbackRing> ReadbackRing::create(std::string_view label, std::size_t bytes, int slots) {
  WL_REQUIRE(bytes > 0 && slots > 0, "a read-back ring holds something");
  ReadbackRing ring;
  ring.m_bytes = bytes;
  constexpr GLbitfield kFlags = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  for (int i = 0; i < slots; ++i) {
    Slot slot;
    GLuint name = 0;
    glCreateBuffers(1, &name);
    slot.buffer = Handle<BufferKind>(name);
    labelObject(BufferKind::kLabel, name, std::string(label) + " slot " + std::to_string(i));
    forgetErrors();
    glNamedBufferStorage(name, static_cast<GLsizeiptr>(bytes), nullptr, kFlags | GL_CLIENT_STORAGE_BIT);
    if (glGetError() == GL_NO_ERROR) {
      slot.mapped =
          static_cast<const std::byte*>(glMapNamedBufferRange(name, 0, static_cast<GLsizeiptr>(bytes), kFlags));
    }
    if (slot.mapped == nullptr) {
      return memoryFailure("OpenGL has no memory to read back '" + std::string(label) + "' of " +
                           std::to_string(bytes) + " bytes");
    }
    ring.m_slots.push_back(std::move(slot));
  }
  return ring;
}

ReadbackRing::ReadbackRing(ReadbackRing&&) noexcept = default;

ReadbackRing& ReadbackRing::operator=(ReadbackRing&& other) noexcept {
  if (this != &other) {
    dropFences();
    m_slots = std::move(other.m_slots);
    m_bytes = other.m_bytes;
    m_next = other.m_next;
    m_failed = other.m_failed;
  }
  return *this;
}

ReadbackRing::~ReadbackRing() {
  dropFences();
}

void ReadbackRing::dropFences() {
  for (Slot& slot : m_slots) {
    if (slot.fence != nullptr) glDeleteSync(slot.fence);
    slot.fence = nullptr;
  }
}

ReadbackRing::Slot* ReadbackRing::freeSlot() {
  Slot& slot = m_slots[m_next];
  if (slot.fence != nullptr) return nullptr;
  m_next = (m_next + 1) % m_slots.size();
  return &slot;
}

bool ReadbackRing::request(const Buffer& source, std::size_t offset, std::size_t bytes, long tag) {
  WL_REQUIRE(bytes <= m_bytes && offset + bytes <= source.bytes(), "the copy fits");
  Slot* slot = freeSlot();
  if (slot == nullptr) return false;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glCopyNamedBufferSubData(source.name(), slot->buffer.name(), static_cast<GLintptr>(offset), 0,
                           static_cast<GLsizeiptr>(bytes));
  slot->bytes = bytes;
  slot->tag = tag;
  slot->fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  return true;
}

bool ReadbackRing::request(GLuint texture, GLenum pixelFormat, GLenum pixelType, long tag) {
  Slot* slot = freeSlot();
  if (slot == nullptr) return false;
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, slot->buffer.name());
  glGetTextureImage(texture, 0, pixelFormat, pixelType, static_cast<GLsizei>(m_bytes), nullptr);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  slot->bytes = m_bytes;
  slot->tag = tag;
  slot->fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  return true;
}

std::optional<ReadbackRing::Arrival> ReadbackRing::takeOldest(Wait wait) {
  constexpr GLuint64 kTenSeconds = 10'000'000'000ull;
  for (std::size_t i = 0; i < m_slots.size(); ++i) {
    // The slot to be used next is the oldest one, if it is in flight.
    Slot& slot = m_slots[(m_next + i) % m_slots.size()];
    if (slot.fence == nullptr) continue;
    const bool waits = wait == Wait::Yes;
    GLenum state = glClientWaitSync(slot.fence, waits ? GL_SYNC_FLUSH_COMMANDS_BIT : 0, waits ? kTenSeconds : 0);
    while (waits && state == GL_TIMEOUT_EXPIRED && !gpuWasReset()) state = glClientWaitSync(slot.fence, 0, kTenSeconds);
    // A lost context may signal every fence; the bytes behind it are anything.
    m_failed = m_failed || state == GL_WAIT_FAILED || (state != GL_TIMEOUT_EXPIRED && gpuWasReset()) ||
               (waits && state == GL_TIMEOUT_EXPIRED);
    if (m_failed) return std::nullopt;
    if (state != GL_ALREADY_SIGNALED && state != GL_CONDITION_SATISFIED) return std::nullopt;
    glDeleteSync(slot.fence);
    slot.fence = nullptr;
    return Arrival{slot.tag, {slot.mapped, slot.bytes}};
  }
  return std::nullopt;
}

std::optional<ReadbackRing::Arrival> ReadbackRing::collect(Wait wait) {
  std::optional<Arrival> newest;
  while (const std::optional<Arrival> arrival = takeOldest(wait)) newest = arrival;
  return newest;
}

std::optional<ReadbackRing::Arrival> ReadbackRing::poll() {
  return collect(Wait::No);
}

std::optional<ReadbackRing::Arrival> ReadbackRing::finish() {
  return collect(Wait::Yes);
}

}  // namespace windloom::gpu
