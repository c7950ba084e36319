// What of the library other programs can link to.
#pragma once

/// Marks what the shared library exports; all else is hidden in it.
#define SUNFLECK_API __attribute__((visibility("default")))
