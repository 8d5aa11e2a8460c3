// As much of the C interface of Open Image Denoise 2 as is used, found in its library when the
// program runs. The library has no headers where it comes from; names and values are its manual's.
#pragma once

#include <cstddef>
#include <string>

namespace tp {

struct OidnDeviceHandle;
struct OidnFilterHandle;
struct OidnBufferHandle;

inline constexpr int kOidnCpu = 1, kOidnCuda = 3;                 // OIDNDeviceType
inline constexpr int kOidnFloat3 = 3;                             // OIDNFormat
inline constexpr int kOidnQualityFast = 4, kOidnQualityHigh = 6;  // OIDNQuality

struct OidnLibrary {
    OidnDeviceHandle* (*new_device)(int type);
    void (*commit_device)(OidnDeviceHandle*);
    void (*release_device)(OidnDeviceHandle*);
    int (*device_error)(OidnDeviceHandle*, const char** message);
    int (*device_int)(OidnDeviceHandle*, const char* name);
    OidnBufferHandle* (*new_buffer)(OidnDeviceHandle*, size_t bytes);
    void (*write_buffer)(OidnBufferHandle*, size_t offset, size_t bytes, const void* from);
    void (*read_buffer)(OidnBufferHandle*, size_t offset, size_t bytes, void* to);
    void (*release_buffer)(OidnBufferHandle*);
    OidnFilterHandle* (*new_filter)(OidnDeviceHandle*, const char* type);
    void (*set_image)(OidnFilterHandle*, const char* name, OidnBufferHandle*, int format,
                      size_t width, size_t height, size_t offset, size_t pixel_stride,
                      size_t row_stride);
    void (*set_bool)(OidnFilterHandle*, const char* name, bool);
    void (*set_int)(OidnFilterHandle*, const char* name, int);
    void (*commit_filter)(OidnFilterHandle*);
    void (*execute_filter)(OidnFilterHandle*);
    void (*release_filter)(OidnFilterHandle*);
};

/// The library, opened once; null where it is not there, and `why` says so.
const OidnLibrary* oidn_library(std::string& why);

}  // namespace tp
