//! Handles of lights in a picture: positions, targets of spot lights, and directions as points on a sphere around the
//! picture's middle.

use luxel_lighting::LightKind;
use luxel_pick::{place_in_picture, point_in_picture};
use luxel_scene::{Camera, DVec2, DVec3, Size};

/// Where a light is and the unit direction in which its light travels, in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightPose {
    /// The position.
    pub position: DVec3,
    /// The direction.
    pub direction: DVec3,
}

/// What a handle shows and moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HandleKind {
    /// A light's position, in world space.
    Position(DVec3),
    /// The point that a spot light aims at, in world space.
    Target(DVec3),
    /// The direction that the light of a directional light comes from, in view space.
    Direction(DVec3),
}

/// A handle in a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightHandle {
    /// What it moves.
    pub kind: HandleKind,
    /// Where it is in the picture, in pixels from the upper left.
    pub place: DVec2,
}

impl LightHandle {
    /// Whether it is on the near side of the sphere of directions; of other handles, true.
    #[must_use]
    pub fn is_near(&self) -> bool {
        !matches!(self.kind, HandleKind::Direction(towards) if towards.z < 0.0)
    }
}

/// The sphere on which directions are shown, in pixels of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectionSphere {
    /// The middle of its outline.
    pub centre: DVec2,
    /// The radius of its outline.
    pub radius: f64,
}

impl DirectionSphere {
    /// The sphere in a picture, or in the part of it that is free: its middle and its size in pixels.
    #[must_use]
    pub fn within(centre: DVec2, width: f64, height: f64) -> Self {
        Self { centre, radius: width.min(height) * 0.3 }
    }

    /// The direction, in view space, of a place on the sphere seen from the front. Within the outline it lies on the
    /// near side if `is_near`, else on the far side; beyond the outline it continues on the other side.
    #[must_use]
    pub fn direction(&self, place: DVec2, is_near: bool) -> DVec3 {
        let offset = (place - self.centre) / self.radius * DVec2::new(1.0, -1.0);
        let radius = offset.length().min(2.0);
        let (within, is_near) =
            if radius <= 1.0 { (radius, is_near) } else { (2.0 - radius, !is_near) };
        let aside = offset.normalize_or_zero() * within;
        let depth = (1.0 - within * within).max(0.0).sqrt();
        aside.extend(if is_near { depth } else { -depth })
    }

    /// Where a direction in view space is shown.
    #[must_use]
    pub fn place(&self, direction: DVec3) -> DVec2 {
        self.centre + direction.truncate() * DVec2::new(1.0, -1.0) * self.radius
    }
}

/// The picture in which handles are shown.
#[derive(Clone, Copy, Debug)]
pub struct HandleView<'a> {
    /// Its camera.
    pub camera: &'a Camera,
    /// Its size in pixels.
    pub size: Size,
    /// The point about which the camera turns: targets of spot lights are shown as far away as it is.
    pub pivot: DVec3,
    /// Where directions are shown.
    pub sphere: DirectionSphere,
}

impl HandleView<'_> {
    /// The handles of a light, in the order in which they are drawn, without those behind the eye.
    #[must_use]
    pub fn handles(&self, kind: LightKind, pose: LightPose) -> Vec<LightHandle> {
        let LightPose { position, direction } = pose;
        let kind = kind.description();
        let kinds = match (kind.has_position, kind.has_direction) {
            (false, false) => Vec::new(),
            (false, true) => {
                let towards = self.camera.view_from_world.transform_vector3(-direction);
                vec![HandleKind::Direction(towards)]
            }
            (true, false) => vec![HandleKind::Position(position)],
            (true, true) => {
                let reach = position.distance(self.pivot);
                let aim = position + direction * if reach > 0.0 { reach } else { 1.0 };
                vec![HandleKind::Target(aim), HandleKind::Position(position)]
            }
        };
        let shown = |kind| Some(LightHandle { kind, place: self.place(kind)? });
        kinds.into_iter().filter_map(shown).collect()
    }

    /// Where a handle is in the picture; `None` behind the eye.
    #[must_use]
    pub fn place(&self, kind: HandleKind) -> Option<DVec2> {
        match kind {
            HandleKind::Direction(towards) => Some(self.sphere.place(towards)),
            HandleKind::Position(point) | HandleKind::Target(point) => {
                Some(place_in_picture(self.camera, self.size, point)?.truncate())
            }
        }
    }

    /// The pose of a light whose handle is moved to a place of the picture: a position at its own depth, a target around
    /// its light, a direction around the sphere, on whose near side it was if `is_near`. `None` where no point is.
    #[must_use]
    pub fn moved(
        &self,
        kind: HandleKind,
        to: DVec2,
        is_near: bool,
        pose: LightPose,
    ) -> Option<LightPose> {
        let to = match kind {
            HandleKind::Direction(_) => self.sphere.direction(to, is_near),
            HandleKind::Position(point) => self.at_depth_of(point, to)?,
            HandleKind::Target(point) => self.around(pose.position, point, to)?,
        };
        Some(self.pose_with(kind, to, pose))
    }

    /// The point at a place of the picture that is as deep as another point.
    fn at_depth_of(&self, point: DVec3, to: DVec2) -> Option<DVec3> {
        let depth = place_in_picture(self.camera, self.size, point)?.z;
        point_in_picture(self.camera, self.size, to.extend(depth))
    }

    /// The point at a place of the picture that is as far from a centre as another point: of two, the one nearer to
    /// that point. Where the line of sight passes the sphere by, its point nearest to the centre.
    fn around(&self, centre: DVec3, point: DVec3, to: DVec2) -> Option<DVec3> {
        let at = self.at_depth_of(point, to)?;
        let sight = match self.camera.projection.is_orthographic() {
            true => self.camera.direction(),
            false => (at - self.camera.eye()).normalize(),
        };
        // |at + t sight - centre|^2 = |point - centre|^2
        let middle = at + sight * sight.dot(centre - at);
        let half = point.distance_squared(centre) - middle.distance_squared(centre);
        if half <= 0.0 {
            return Some(middle);
        }
        let half = sight * half.sqrt();
        let is_seen = |end: &DVec3| place_in_picture(self.camera, self.size, *end).is_some();
        let nearer =
            |a: &DVec3, b: &DVec3| a.distance_squared(point).total_cmp(&b.distance_squared(point));
        [middle - half, middle + half].into_iter().filter(is_seen).min_by(nearer)
    }

    /// The pose of a light whose handle is moved along the line of sight, away from the eye by this part of its
    /// distance. Directions stay.
    #[must_use]
    pub fn moved_away(&self, kind: HandleKind, part: f64, pose: LightPose) -> LightPose {
        let (HandleKind::Position(point) | HandleKind::Target(point)) = kind else { return pose };
        let to = if self.camera.projection.is_orthographic() {
            let depth = -self.camera.view_from_world.transform_point3(point).z;
            point + self.camera.direction() * (part * depth.abs().max(1e-3))
        } else {
            let eye = self.camera.eye();
            eye + (point - eye) * (1.0 + part).max(0.1)
        };
        self.pose_with(kind, to, pose)
    }

    /// The pose of a light whose handle is at a point, or shows a direction.
    fn pose_with(&self, kind: HandleKind, to: DVec3, pose: LightPose) -> LightPose {
        match kind {
            HandleKind::Position(_) => LightPose { position: to, ..pose },
            HandleKind::Target(_) => {
                let direction = (to - pose.position).normalize_or(pose.direction);
                LightPose { direction, ..pose }
            }
            HandleKind::Direction(_) => {
                let direction = -self.camera.view_from_world.inverse().transform_vector3(to);
                LightPose { direction, ..pose }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luxel_lighting::Cone;
    use luxel_scene::{Lens, Projection};

    const SIZE: Size = Size { width: 800, height: 600 };
    const POSE: LightPose = LightPose {
        position: DVec3::new(1.0, 0.5, -1.0),
        direction: DVec3::new(-0.36, -0.48, -0.8),
    };

    fn camera(lens: Lens) -> Camera {
        let view_from_world = Camera::look_at(DVec3::new(0.0, 2.0, 9.0), DVec3::ZERO, DVec3::Y);
        Camera { view_from_world, projection: Projection { lens, near: 0.1, far: 50.0 } }
    }

    fn view(camera: &Camera) -> HandleView<'_> {
        let sphere = DirectionSphere::within(DVec2::new(400.0, 300.0), 800.0, 600.0);
        HandleView { camera, size: SIZE, pivot: DVec3::ZERO, sphere }
    }

    #[test]
    fn the_far_side_is_reached_over_the_outline_without_a_jump() {
        let sphere = DirectionSphere { centre: DVec2::new(3.0, 4.0), radius: 10.0 };
        let at =
            |reach: f64| sphere.direction(DVec2::new(3.0 + 6.0 * reach, 4.0 - 8.0 * reach), true);
        for step in 0..=200 {
            let reach = f64::from(step) / 100.0;
            assert!((at(reach).length() - 1.0).abs() < 1e-12, "{reach}");
            assert_eq!(at(reach).z >= 0.0, reach <= 1.0, "{reach}");
        }
        assert!(at(0.9999).distance(at(1.0001)) < 0.05);
        assert!(at(2.0).abs_diff_eq(DVec3::NEG_Z, 1e-12) && at(9.0) == at(2.0));
        // A handle on the far side follows the pointer, and crosses the outline to the near side.
        let far = sphere.direction(DVec2::new(8.0, 4.0), false);
        assert!(far.abs_diff_eq(DVec3::new(0.5, 0.0, -(0.75_f64.sqrt())), 1e-12));
        assert!(sphere.place(far).abs_diff_eq(DVec2::new(8.0, 4.0), 1e-12));
        assert!(sphere.direction(DVec2::new(18.0, 4.0), false).z > 0.0);
    }

    #[test]
    fn a_handle_is_where_it_was_moved_to_whatever_it_moves() {
        for lens in [Lens::Perspective { fov_y_radians: 0.8 }, Lens::Orthographic { height: 6.0 }] {
            let camera = camera(lens);
            let view = view(&camera);
            for (kind, count) in
                [(LightKind::Point, 1), (LightKind::Directional, 1), (LightKind::Ambient, 0)]
            {
                let handles = view.handles(kind, POSE);
                assert_eq!(handles.len(), count);
                for handle in handles {
                    let to = handle.place + DVec2::new(40.0, -30.0);
                    let pose = view.moved(handle.kind, to, handle.is_near(), POSE).unwrap();
                    let again = view.handles(kind, pose)[0];
                    assert!(again.place.abs_diff_eq(to, 1e-6), "{lens:?} {handle:?} {again:?}");
                }
            }
        }
    }

    #[test]
    fn a_position_keeps_its_depth_and_goes_deeper_at_the_same_place() {
        for lens in [Lens::Perspective { fov_y_radians: 0.8 }, Lens::Orthographic { height: 6.0 }] {
            let camera = camera(lens);
            let view = view(&camera);
            let handle = view.handles(LightKind::Point, POSE)[0];
            let depth = |pose: LightPose| -camera.view_from_world.transform_point3(pose.position).z;
            let to = handle.place + DVec2::new(60.0, -40.0);
            let aside = view.moved(handle.kind, to, true, POSE).unwrap();
            assert!((depth(aside) - depth(POSE)).abs() < 1e-6, "{lens:?}");
            let deeper = view.moved_away(handle.kind, 0.12, POSE);
            let place = view.handles(LightKind::Point, deeper)[0].place;
            assert!(place.abs_diff_eq(handle.place, 1e-6), "{lens:?}");
            assert!(depth(deeper) > depth(POSE) + 0.1, "{lens:?}");
        }
    }

    #[test]
    fn a_spot_light_stays_and_turns_until_its_target_is_where_it_was_moved_to() {
        for lens in [Lens::Perspective { fov_y_radians: 0.8 }, Lens::Orthographic { height: 6.0 }] {
            let camera = camera(lens);
            let view = view(&camera);
            let kind = LightKind::Spot(Cone::Exponent { exponent: 1.0, cos_cutoff: 0.9 });
            let [target, position] = view.handles(kind, POSE)[..] else { panic!("two handles") };
            assert_eq!(position.kind, HandleKind::Position(POSE.position));
            for offset in [DVec2::new(40.0, -60.0), DVec2::new(-25.0, 10.0)] {
                let to = target.place + offset;
                let pose = view.moved(target.kind, to, true, POSE).unwrap();
                assert_eq!(pose.position, POSE.position);
                assert!((pose.direction.length() - 1.0).abs() < 1e-12);
                let [moved, _] = view.handles(kind, pose)[..] else { panic!("two handles") };
                assert!(moved.place.abs_diff_eq(to, 1e-6), "{lens:?}: {moved:?} is not at {to}");
            }
            let stays = view.moved(target.kind, target.place, true, POSE).unwrap();
            assert!(stays.direction.abs_diff_eq(POSE.direction, 1e-9), "{lens:?}");
        }
    }

    #[test]
    fn a_target_that_is_moved_beyond_its_reach_lies_in_that_direction() {
        let camera = camera(Lens::Perspective { fov_y_radians: 0.8 });
        let view = view(&camera);
        let kind = LightKind::Spot(Cone::Exponent { exponent: 1.0, cos_cutoff: 0.9 });
        let [target, position] = view.handles(kind, POSE)[..] else { panic!("two handles") };
        let way = DVec2::new(3.0, -4.0).normalize();
        let to = position.place + way * 400.0;
        let pose = view.moved(target.kind, to, true, POSE).unwrap();
        let [moved, _] = view.handles(kind, pose)[..] else { panic!("two handles") };
        assert!((moved.place - position.place).normalize().dot(way) > 0.99, "{moved:?}");
        // The light shines across the line of sight.
        let sight = point_in_picture(&camera, SIZE, to.extend(0.5)).unwrap() - camera.eye();
        assert!(pose.direction.dot(sight.normalize()).abs() < 1e-9, "{pose:?}");
    }
}
