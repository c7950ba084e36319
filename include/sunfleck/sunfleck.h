// All of the library's interface. docs/reference/library.md says how it is used and what may be
// called at the same time.
#pragma once

#include <sunfleck/error.h>
#include <sunfleck/parameters.h>
#include <sunfleck/picture.h>
#include <sunfleck/renderer.h>
#include <sunfleck/scene.h>
#include <sunfleck/scene_builder.h>
#include <sunfleck/settings.h>
#include <sunfleck/transform.h>
#include <sunfleck/version.h>
