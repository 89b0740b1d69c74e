//! Poses of lights in world space, changes of their coordinate space, new lights.

use super::handles::LightPose;
use luxel_lighting::{Light, LightKindDescription};
use luxel_scene::{DMat4, DVec3, Placement, SceneLight};

/// The coordinate spaces of lights.
#[derive(Clone, Copy, Debug)]
pub struct LightSpaces<'a> {
    /// From world space to the camera's.
    pub view_from_world: DMat4,
    /// From each node's space to world space.
    pub world_from_nodes: &'a [DMat4],
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

    /// A light's pose in world space.
    #[must_use]
    pub fn world_pose(&self, light: &SceneLight) -> LightPose {
        let world = self.world_from(light.placement);
        let direction = world.transform_vector3(light.direction).normalize_or(DVec3::NEG_Z);
        LightPose { position: world.transform_point3(light.position), direction }
    }

    /// Moves a light to a pose in world space; no effect if its own space can't express it.
    pub fn set_world_pose(&self, light: &mut SceneLight, pose: LightPose) {
        let light_from_world = self.world_from(light.placement).inverse();
        let direction = light_from_world.transform_vector3(pose.direction);
        let position = light_from_world.transform_point3(pose.position);
        if position.is_finite() && direction.is_finite() && direction.length_squared() > 0.0 {
            (light.position, light.direction) = (position, direction.normalize());
        }
    }

    /// Changes a light's coordinate space and keeps its pose in world space.
    pub fn change_placement(&self, light: &mut SceneLight, placement: Placement) {
        if light.placement != placement {
            let pose = self.world_pose(light);
            light.placement = placement;
            self.set_world_pose(light, pose);
        }
    }

    /// A new light at one point of the world that shines at another.
    #[must_use]
    pub fn new_light(
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
        let direction = (to - from).normalize_or(DVec3::NEG_Y);
        self.set_world_pose(&mut light, LightPose { position: from, direction });
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
    use luxel_lighting::LightKind;
    use luxel_scene::{Camera, NodeId};

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
            let LightPose { position, direction } = spaces.world_pose(&light);
            assert!(position.abs_diff_eq(before.position, 1e-12), "{placement:?}: {position}");
            assert!(direction.abs_diff_eq(before.direction, 1e-12), "{placement:?}: {direction}");
        }
        assert!(light.position.abs_diff_eq(DVec3::new(1.0, 2.0, 3.0), 1e-12));
    }

    #[test]
    fn a_light_does_not_move_in_a_singular_space() {
        let flat = DMat4::from_scale(DVec3::ZERO);
        let spaces = LightSpaces { view_from_world: DMat4::IDENTITY, world_from_nodes: &[flat] };
        let mut light = SceneLight { placement: Placement::Node(NodeId(0)), ..light() };
        let before = light.clone();
        let pose = LightPose { position: DVec3::ONE, direction: DVec3::X };
        spaces.set_world_pose(&mut light, pose);
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
