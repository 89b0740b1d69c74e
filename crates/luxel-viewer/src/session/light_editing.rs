//! Editing of lights: poses in world space, changes of their coordinate space, new lights.

use luxel::lighting::{Light, LightKindDescription};
use luxel::scene::{DMat4, DVec3, Placement, SceneLight};

/// The coordinate spaces of lights.
pub(crate) struct LightSpaces<'a> {
    pub(crate) view_from_world: DMat4,
    pub(crate) world_from_nodes: &'a [DMat4],
}

impl LightSpaces<'_> {
    /// From a light's coordinate space to world space.
    fn world_from(&self, placement: Placement) -> DMat4 {
        match placement {
            Placement::World => DMat4::IDENTITY,
            Placement::Camera => self.view_from_world.inverse(),
            Placement::Node(node) => {
                self.world_from_nodes.get(node.index()).copied().unwrap_or_default()
            }
        }
    }

    /// A light's position, and the unit direction in which its light travels, in world space.
    pub(crate) fn world_pose(&self, light: &SceneLight) -> (DVec3, DVec3) {
        let world = self.world_from(light.placement);
        let direction = world.transform_vector3(light.direction);
        (world.transform_point3(light.position), direction.normalize_or(DVec3::NEG_Z))
    }

    /// Moves a light to a pose in world space; no effect if its own space can't express it.
    pub(crate) fn set_world_pose(&self, light: &mut SceneLight, position: DVec3, direction: DVec3) {
        let light_from_world = self.world_from(light.placement).inverse();
        let direction = light_from_world.transform_vector3(direction);
        let position = light_from_world.transform_point3(position);
        if position.is_finite() && direction.is_finite() && direction.length_squared() > 0.0 {
            (light.position, light.direction) = (position, direction.normalize());
        }
    }

    /// Changes a light's coordinate space and keeps its pose in world space.
    pub(crate) fn change_placement(&self, light: &mut SceneLight, placement: Placement) {
        if light.placement != placement {
            let (position, direction) = self.world_pose(light);
            light.placement = placement;
            self.set_world_pose(light, position, direction);
        }
    }

    /// A new light at one point of the world that shines at another.
    pub(crate) fn new_light(
        &self,
        kind: &LightKindDescription,
        [from, to]: [DVec3; 2],
        others: &[SceneLight],
    ) -> SceneLight {
        let mut light = SceneLight {
            name: unused_name(kind.name, others),
            light: Light::new(kind.kind, [0.6; 3]),
            placement: Placement::World,
            position: DVec3::ZERO,
            direction: DVec3::NEG_Z,
        };
        self.set_world_pose(&mut light, from, (to - from).normalize_or(DVec3::NEG_Y));
        light
    }
}

/// A name that no other light has.
fn unused_name(name: &str, others: &[SceneLight]) -> String {
    let is_free = |name: &String| others.iter().all(|other| other.name != *name);
    let numbered = (2..).map(|number| format!("{name}{number}"));
    std::iter::once(name.to_owned()).chain(numbered).find(is_free).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel::lighting::LightKind;
    use luxel::scene::{Camera, NodeId};

    fn light() -> SceneLight {
        SceneLight {
            name: "spot".to_owned(),
            light: Light::new(LightKind::Point, [1.0; 3]),
            placement: Placement::World,
            position: DVec3::new(1.0, 2.0, 3.0),
            direction: DVec3::new(0.6, 0.0, -0.8),
        }
    }

    #[test]
    fn a_light_keeps_its_pose_in_every_coordinate_space() {
        let view_from_world = Camera::look_at(DVec3::new(5.0, 4.0, 9.0), DVec3::ONE, DVec3::Y);
        let node = DMat4::from_rotation_x(0.7) * DMat4::from_scale(DVec3::splat(3.0));
        let spaces = LightSpaces { view_from_world, world_from_nodes: &[node] };
        let mut light = light();
        let before = spaces.world_pose(&light);
        for placement in
            [Placement::Camera, Placement::Node(NodeId(0)), Placement::Camera, Placement::World]
        {
            spaces.change_placement(&mut light, placement);
            let (position, direction) = spaces.world_pose(&light);
            assert!(position.abs_diff_eq(before.0, 1e-12), "{placement:?}: {position}");
            assert!(direction.abs_diff_eq(before.1, 1e-12), "{placement:?}: {direction}");
        }
        assert!(light.position.abs_diff_eq(DVec3::new(1.0, 2.0, 3.0), 1e-12));
    }

    #[test]
    fn a_light_does_not_move_in_a_singular_space() {
        let flat = DMat4::from_scale(DVec3::ZERO);
        let spaces = LightSpaces { view_from_world: DMat4::IDENTITY, world_from_nodes: &[flat] };
        let mut light = SceneLight { placement: Placement::Node(NodeId(0)), ..light() };
        let before = light.clone();
        spaces.set_world_pose(&mut light, DVec3::ONE, DVec3::X);
        assert_eq!(light, before);
    }

    #[test]
    fn new_lights_have_unique_names_and_shine_at_the_target() {
        let spaces = LightSpaces { view_from_world: DMat4::IDENTITY, world_from_nodes: &[] };
        let ends = [DVec3::new(9.0, 3.0, 4.0), DVec3::new(10.0, 0.0, 0.0)];
        let mut lights = Vec::new();
        for kind in ["point", "point", "spot", "directional"] {
            let kind = LightKindDescription::by_name(kind).unwrap();
            lights.push(spaces.new_light(kind, ends, &lights));
        }
        let names: Vec<_> = lights.iter().map(|light| light.name.as_str()).collect();
        assert_eq!(names, ["point", "point2", "spot", "directional"]);
        let spot = &lights[2];
        assert!(spot.direction.abs_diff_eq((ends[1] - ends[0]).normalize(), 1e-12));
        assert_eq!(spot.position, ends[0]);
    }
}
