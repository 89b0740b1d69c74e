use super::*;
use luxel_math::SimdLevel;
use luxel_scene::{
    DMat4, Encoding, Filter, Image, Lens, MaterialId, Mesh, Part, Projection, Sampler,
    SceneMaterial, Size, Texture, TextureId, TextureUse,
};
use luxel_visibility::{Clusters, Coverage, Frames, Instance, PartUse, Samples, ViewFromLocal};
use std::sync::Arc;

/// Numbers from 0 to 1, always the same ones.
struct Noise(u32);

impl Noise {
    fn next(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (self.0 >> 8) as f32 / (1 << 24) as f32
    }

    fn below(&mut self, count: usize) -> usize {
        (self.next() * count as f32) as usize
    }
}

const SIDE: u32 = 200;
const TRIANGLES: usize = 600;

/// Triangles of all sizes in three parts: masked, blended with a map and colours of its own, opaque.
fn scene() -> Scene {
    let mut noise = Noise(7);
    let mut mesh = Mesh::default();
    for number in 0..TRIANGLES as u32 {
        let size = 1.0 / (1_u32 << (number % 8)) as f32;
        let middle: [f32; 3] =
            std::array::from_fn(|axis| noise.next() * 2.0 - if axis == 2 { 5.0 } else { 1.0 });
        for _ in 0..3 {
            mesh.positions.push(middle.map(|at| at + size * (noise.next() - 0.5)));
            mesh.uvs[0].push([noise.next() * 4.0 - 2.0, noise.next()]);
            mesh.uvs[1].push([noise.next(), noise.next() * 3.0]);
            mesh.colors.push([1.0, 1.0, 1.0, noise.next() - 0.3]);
        }
        mesh.triangles.push([0, 1, 2].map(|corner| 3 * number + corner));
    }
    let each = TRIANGLES as u32 / 3;
    mesh.parts =
        [0, 1, 2].map(|n| Part { first: n * each, count: each, material: MaterialId(n) }).to_vec();
    let mut texels = |count| -> Vec<[u8; 4]> {
        (0..count).map(|_| std::array::from_fn(|_| noise.below(256) as u8)).collect()
    };
    let (first, second) = (texels(7 * 5), texels(8 * 8));
    let of = |texels, width, height, magnify| Texture {
        image: Arc::new(Image::new("noise", Encoding::Linear, width, height, texels)),
        sampler: Sampler { magnify, ..Sampler::trilinear() },
    };
    let used =
        |texture, uv_set| Box::new(TextureUse { uv_set, ..TextureUse::new(TextureId(texture)) });
    let masked = SceneMaterial {
        alpha_mode: AlphaMode::Mask { cutoff: 0.5 },
        base_color: Some(used(0, 0)),
        vertex_colors: false,
        ..SceneMaterial::default()
    };
    let blended = SceneMaterial {
        alpha_mode: AlphaMode::Blend,
        base_color: Some(used(0, 1)),
        opacity_map: Some(used(1, 0)),
        vertex_colors: true,
        ..SceneMaterial::default()
    };
    Scene {
        meshes: vec![mesh].into(),
        materials: vec![masked, blended, SceneMaterial::default()],
        textures: vec![of(first, 7, 5, Filter::Linear), of(second, 8, 8, Filter::Nearest)],
        ..Scene::default()
    }
}

/// Calls `check` with a frame of the scene and who tells of its holes, at every level.
fn at_every_level(wires: Option<Edges>, check: impl Fn(&Scene, &Frame<'_>, &AlphaTester<'_>)) {
    let scene = scene();
    let mesh = &scene.meshes[0];
    let clusters = Clusters::new(mesh, Frames::Many);
    let part = PartUse { coverage: Coverage::Cutout, ..PartUse::default() };
    let place = ViewFromLocal::new(&DMat4::IDENTITY, mesh.origin);
    let instance = Instance {
        mesh,
        clusters: &clusters,
        view_from_local: &place,
        parts: [part; 3].into(),
        ranks: &[],
        is_repeated: false,
    };
    let lens = Lens::Perspective { fov_y_radians: 0.8 };
    let projection = Projection { lens, near: 0.1, far: 20.0 };
    let size = Size { width: SIDE, height: SIDE };
    let flags = EdgeFlags::new(mesh);
    let edge_flags = [Some(&flags)];
    let cutouts = AlphaTest { scene: &scene, wires, edge_flags: &edge_flags };
    for level in SimdLevel::available() {
        let level = level.resolve().unwrap();
        let samples = Samples::new(1).unwrap();
        let frame = Frame::new(vec![instance.clone()], &projection, size, samples, level).unwrap();
        check(&scene, &frame, &cutouts.finder(&frame, level));
    }
}

/// Samples of so many triangles, on them and beside them.
fn asked(noise: &mut Noise, ids: &[TriangleId], several: usize) -> Asked {
    let some: Vec<TriangleId> = (0..several).map(|_| ids[noise.below(ids.len())]).collect();
    let mut place = || (noise.below(256 * SIDE as usize)) as f32 / 256.0;
    let [x, y] = [(); 2].map(|()| std::array::from_fn(|_| place()));
    let ids = std::array::from_fn(|_| some[noise.below(several)]);
    Asked { ids, x, y, lanes: noise.below(1 << LANES) as u32 }
}

#[test]
fn sixteen_samples_have_the_holes_that_each_has_alone() {
    at_every_level(None, |scene, frame, finder| {
        let mut noise = Noise(3);
        let ids: Vec<TriangleId> = frame.triangle_ids().collect();
        assert_eq!(ids.len(), TRIANGLES);
        let mut counts = [0; 2];
        for several in (1..=LANES).cycle().take(2000) {
            let asked = asked(&mut noise, &ids, several);
            let holes = finder.holes(&asked);
            assert_eq!(holes & !asked.lanes, 0, "an answer that nobody asked for");
            for lane in lanes_of(asked.lanes) {
                let of = frame.triangle(asked.ids[lane]).unwrap();
                let mesh = &scene.meshes[0];
                let at = frame.forms(of).exact_barycentric(frame.rays(), asked.position(lane));
                let hole = scene.is_hole(mesh, of.triangle, at, &scene.materials[of.part]);
                assert_eq!(holes >> lane & 1 == 1, hole, "{of:?} at {at:?}");
                counts[usize::from(hole)] += 1;
            }
        }
        assert!(counts.iter().all(|&count| count > 2000), "{counts:?}");
    });
}

#[test]
fn sixteen_samples_lie_between_the_wires_that_each_lies_between_alone() {
    let wires = Edges { width: 3.0, ..Edges::WIREFRAME };
    at_every_level(Some(wires), |_, frame, finder| {
        let mut noise = Noise(5);
        let ids: Vec<TriangleId> =
            frame.triangle_ids().filter(|&id| frame.triangle(id).unwrap().part == 2).collect();
        let mut counts = [0; 2];
        for several in (1..=LANES).cycle().take(500) {
            let asked = asked(&mut noise, &ids, several);
            let holes = finder.holes(&asked);
            for lane in lanes_of(asked.lanes) {
                let forms = frame.forms(frame.triangle(asked.ids[lane]).unwrap());
                let [x, y] = [asked.x[lane], asked.y[lane]].map(f64::from);
                let hole = edge_distance(&forms, 0b111, x, y) > 1.5;
                assert_eq!(holes >> lane & 1 == 1, hole);
                counts[usize::from(hole)] += 1;
            }
        }
        assert!(counts.iter().all(|&count| count > 20), "{counts:?}");
    });
}
