// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/surface_values.h"

/// Material models of game engines, for punctual lights (without area). Both omit the engines' optional compensation of
/// multiple scattering.
namespace gonio::exports {

/// Default Lit of Unreal Engine (Karis 2013, "Real Shading in Unreal Engine 4"): Lambert, GGX with an approximated
/// joint Smith term, Schlick with F_0 = 0.08 * specular for dielectrics.
const SurfaceShader& unrealShader();

/// Lit of Unity's High Definition Render Pipeline (Lagarde and de Rousiers 2014, "Moving Frostbite to PBR", with the
/// renormalised diffuse lobe of Burley): GGX with the joint Smith term, Schlick with F_0 = 0.04 for dielectrics.
const SurfaceShader& unityShader();

}  // namespace gonio::exports
