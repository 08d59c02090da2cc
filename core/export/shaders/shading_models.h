// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <string>

#include "core/export/shaders/reciprocal_lobes.h"
#include "core/export/shaders/surface_values.h"
#include "core/export/shaders/view_lobes.h"

/// The shading models of other programs: their formulas, which the fits evaluate, and the texts in which the programs
/// read the fitted values. The source of a program's target defines them.
namespace gonio::exports {

/// The material of glTF 2.0 (Khronos 2021, appendix B) with the extensions KHR_materials_specular, clearcoat, sheen and
/// anisotropy: a metal with Schlick's term, a dielectric of index 1.5 with a highlight that attenuates its diffuse
/// lobe, the sheen of Estévez and Kulla 2017 with the visibility term of Neubelt and Pettineo 2013, and a coat of index
/// 1.5. GGX with the height-correlated Smith term, single scattering. Not reciprocal with a coat.
const SurfaceShader& gltfShader();
/// NAME.gltf: a sphere with the material and an embedded buffer, UTF-8. Contains only extensions that have an effect.
/// @param origin text of asset.extras.
std::string gltfDocument(const SurfaceValues& values, const std::string& name, const std::string& origin);

/// The Principled BSDF in Cycles, distribution GGX, index of refraction 1.5.
/// Blender 4 (verified with 4.3.2): GGX with the height-correlated Smith term. A metal with Schlick's term and a tint
/// at 82 degrees (specularColour; Hoffman 2023, "Generalization of Adobe's Fresnel Model"). A dielectric with a Fresnel
/// term that rises from 0.08 * specular * specularColour to 1 in the shape of the exact dielectric formula, over a
/// Lambertian lobe that is attenuated by the albedo of this highlight for the viewer. A coat of index 1.5, which
/// attenuates what is below by its Fresnel term for the viewer. Not reciprocal.
/// Blender 3 (verified with 3.4.1; Burley 2012, "Physically-Based Shading at Disney", with changes): the diffuse lobe
/// with retro-reflection; GGX with the separable term of Walter et al. 2007 and a Fresnel term that rises from F_0
/// (0.08 * specular for dielectrics, with the hue of the base colour by specularTint) to 1 in the same shape; a GTR1
/// coat with the weight 0.25 * coat. No layer attenuates the one below. Reciprocal.
const SurfaceShader& principledShader(BlenderVersion blender = BlenderVersion::v4);
/// A Python script that creates a Principled BSDF, with values for one series of Blender; in the other one the material
/// looks different. @param name of the material. @param origin of the material.
std::string principledScript(const SurfaceValues& values, BlenderVersion blender, const std::string& name,
                             const std::string& origin);
/// A Python script for Blender 3.4 and later that creates a material of the lobes. Parameters as principledScript().
std::string blenderScript(const ViewLobes& lobes, const std::string& name, const std::string& origin);

// Shaders as the node graphs of MaterialX 1.39 define them: GGX lobes with the height-correlated Smith term and
// compensation of multiple scattering (Turquin 2019), and layers that attenuate those below by their directional
// albedo for the viewer, which makes them not reciprocal. MaterialX approximates these albedos by a rational function;
// here they are integrals, which differ by up to about 0.01.

/// open_pbr_surface 1.1 (OpenPBR, Academy Software Foundation 2024), without fuzz, thin film, subsurface and
/// transmission; coat_ior 1.6, coat_darkening 1, specular_weight 1: specularColour and ior set the highlight.
const SurfaceShader& openPbrShader();

/// standard_surface 1.0.1 (Georgiev et al. 2019, "Autodesk Standard Surface"), without sheen, thin film, subsurface and
/// transmission; coat_IOR 1.5, specular 1.
const SurfaceShader& standardSurfaceShader();

/// The sum of oren_nayar_diffuse_bsdf with roughness 0 and generalized_schlick_bsdf lobes: reciprocal lobes, each times
/// scatteringCompensation() for its Fresnel value.
std::unique_ptr<const Brdf> schlickLobesBrdf(const ReciprocalLobes& lobes);

// MaterialX 1.39 documents, UTF-8, in linear sRGB (lin_rec709). The origin is in a comment.
std::string schlickLobesDocument(const ReciprocalLobes& lobes, const std::string& name, const std::string& origin);
std::string openPbrDocument(const SurfaceValues& values, const std::string& name, const std::string& origin);
std::string standardSurfaceDocument(const SurfaceValues& values, const std::string& name, const std::string& origin);

// Material models of game engines, for punctual lights (without area). Both omit the engines' optional compensation of
// multiple scattering.

/// Default Lit of Unreal Engine (Karis 2013, "Real Shading in Unreal Engine 4"): Lambert, GGX with an approximated
/// joint Smith term, Schlick with F_0 = 0.08 * specular for dielectrics.
const SurfaceShader& unrealShader();

/// Lit of Unity's High Definition Render Pipeline (Lagarde and de Rousiers 2014, "Moving Frostbite to PBR", with the
/// renormalised diffuse lobe of Burley): GGX with the joint Smith term, Schlick with F_0 = 0.04 for dielectrics.
const SurfaceShader& unityShader();

/// The lobes as the function vec3 gonioBrdf(vec3 wi, vec3 wo) for GLSL 3.30 and GLSL ES 3.00. Its arguments are unit
/// vectors in the shading frame that point away from the surface; z is the normal, x the tangent. It returns linear
/// sRGB, 1/sr, without the cosine, 0 below the horizon. @param origin text of the first lines.
std::string glslFunction(const ReciprocalLobes& lobes, const std::string& origin);

}  // namespace gonio::exports
