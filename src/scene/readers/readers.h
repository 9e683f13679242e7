// SPDX-License-Identifier: MIT
// The readers of what is no shape and no material.
#pragma once

#include "scene/xml/properties.h"
#include "scene/xml/scene_builder.h"

namespace strahl {

/// An <emitter> outside shapes (lights.def); area emitters belong to shapes.
void read_light(const XmlElement& element, SceneBuilder& builder);
/// Its sampling_weight, 1 where there is none; one below 0 is an error.
[[nodiscard]] double read_sampling_weight(Properties& properties);
/// The object of a kind inside a plugin; null: none. Further ones are errors.
[[nodiscard]] const XmlElement* only_object(Properties& properties, std::string_view tag);
/// <sensor> with its film and sampler.
void read_sensor(const XmlElement& element, SceneBuilder& builder);
/// Of all <sensor>s of the scene the one that is chosen; without any a camera that frames it.
void read_sensors(const std::vector<const XmlElement*>& elements, const XmlElement& root, SceneBuilder& builder);
[[nodiscard]] Film read_film(const XmlElement& element, SceneBuilder& builder);
[[nodiscard]] Filter read_filter(const XmlElement& element, SceneBuilder& builder);
[[nodiscard]] SamplerSettings read_sampler(const XmlElement& element, SceneBuilder& builder);
[[nodiscard]] IntegratorSettings read_integrator(const XmlElement& element, SceneBuilder& builder);
/// Of one around others: the first inside it, or `auto`. name: that one's, where it has one.
[[nodiscard]] IntegratorSettings read_inner_integrator(Properties& properties, SceneBuilder& builder,
                                                       std::string* name = nullptr);
/// Integrator `aov`: the one inside it, with what is written beside its picture.
[[nodiscard]] IntegratorSettings read_aov(Properties& properties, SceneBuilder& builder);
/// Integrator `moment`, alike.
[[nodiscard]] IntegratorSettings read_moment(Properties& properties, SceneBuilder& builder);

}  // namespace strahl
