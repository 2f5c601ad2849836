#ifndef WINDLOOM_RUNTIME_CHECKSUM_H
#define WINDLOOM_RUNTIME_CHECKSUM_H
/* CRC-32 of ISO 3309 (polynomial 0xEDB88320 reflected), the one of zlib and PNG, so that any language's
 * library can check a pack. */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The checksum of the bytes behind those that gave `checksum`; 0 starts. */
uint32_t windloom_checksum(uint32_t checksum, const void* bytes, size_t size);

/* The same by tables alone, as on processors without a carry-less multiplication. */
uint32_t windloom_checksum_plain(uint32_t checksum, const void* bytes, size_t size);

/* The same by carry-less multiplication; see checksum_folded.c. */
int windloom_has_folded_checksum(void);
/* Only where windloom_has_folded_checksum(); `size` is a multiple of 16 and at least 64. */
uint32_t windloom_checksum_folded(uint32_t checksum, const void* bytes, size_t size);

#ifdef __cplusplus
}
#endif
#endif
