// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/reciprocal_lobes.h"
#include "core/export/surface_values.h"

/// Shaders as the node graphs of MaterialX 1.39 define them: GGX lobes with the height-correlated Smith term and
/// compensation of multiple scattering (Turquin 2019), and layers that attenuate those below by their directional
/// albedo for the viewer, which makes them not reciprocal. MaterialX approximates these albedos by a rational function;
/// here they are integrals, which differ by up to about 0.01.
namespace gonio::exports {

/// open_pbr_surface 1.1 (OpenPBR, Academy Software Foundation 2024), without fuzz, thin film, subsurface and
/// transmission; coat_ior 1.6, coat_darkening 1, specular_weight 1: specularColour and ior set the highlight.
const SurfaceShader& openPbrShader();

/// standard_surface 1.0.1 (Georgiev et al. 2019, "Autodesk Standard Surface"), without sheen, thin film, subsurface and
/// transmission; coat_IOR 1.5, specular 1.
const SurfaceShader& standardSurfaceShader();

/// The sum of oren_nayar_diffuse_bsdf with roughness 0 and generalized_schlick_bsdf lobes: reciprocal lobes, each times
/// scatteringCompensation() for its Fresnel value.
std::unique_ptr<const Brdf> schlickLobesBrdf(const ReciprocalLobes& lobes);

}  // namespace gonio::exports
