//! Scenes and views as bytes, for other processes: pickles, workers, browsers.

use luxel_lighting::{EnvironmentMap, Fog};
use luxel_scene::{
    Background, DVec3, EnvironmentChoice, Image, Meshes, Node, Sampler, Scene, SceneCamera,
    SceneLight, SceneMaterial, Texture, UnsoundScene,
};
use luxel_view::View;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::sync::Arc;

/// The first bytes: what follows is read by the same version only.
const HEADER: &str = concat!("luxel ", env!("CARGO_PKG_VERSION"), "\n");

/// Bytes that aren't a packed scene or view.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum UnpackError {
    /// They were packed by another version, or by something else.
    #[error("not packed by luxel {}", env!("CARGO_PKG_VERSION"))]
    Version,
    /// They are cut off or damaged.
    #[error("cut off or damaged: {0}")]
    Damaged(postcard::Error),
    /// A number in them refers to what isn't there.
    #[error("{0} refers to what isn't there")]
    Dangling(String),
    /// The scene isn't sound.
    #[error(transparent)]
    Unsound(#[from] UnsoundScene),
}

/// A scene whose textures share images by number.
#[derive(Deserialize, Serialize)]
struct PackedScene<'s> {
    nodes: Cow<'s, [Node]>,
    meshes: Cow<'s, Meshes>,
    materials: Cow<'s, [SceneMaterial]>,
    images: Vec<Cow<'s, Image>>,
    textures: Vec<(u32, Sampler)>,
    cameras: Cow<'s, [SceneCamera]>,
    lights: Cow<'s, [SceneLight]>,
    environment: Cow<'s, Option<EnvironmentChoice>>,
    ambient: Option<[f32; 3]>,
    fog: Option<Fog>,
    background: Option<Background>,
    up: DVec3,
}

/// A scene as bytes, which [`unpack`] of the same version reads: to the bit, with its normals and tangents.
#[must_use]
pub fn pack(scene: &Scene) -> Vec<u8> {
    let mut images: Vec<&Arc<Image>> = Vec::new();
    let mut place_of = |image| {
        let known = images.iter().position(|other| Arc::ptr_eq(other, image));
        known.unwrap_or_else(|| {
            images.push(image);
            images.len() - 1
        })
    };
    let textures = &scene.textures;
    let textures =
        textures.iter().map(|texture| (place_of(&texture.image) as u32, texture.sampler));
    let textures = textures.collect();
    bytes_of(&PackedScene {
        nodes: Cow::Borrowed(&scene.nodes),
        meshes: Cow::Borrowed(&scene.meshes),
        materials: Cow::Borrowed(&scene.materials),
        images: images.into_iter().map(|image| Cow::Borrowed(&**image)).collect(),
        textures,
        cameras: Cow::Borrowed(&scene.cameras),
        lights: Cow::Borrowed(&scene.lights),
        environment: Cow::Borrowed(&scene.environment),
        ambient: scene.ambient,
        fog: scene.fog,
        background: scene.background,
        up: scene.up,
    })
}

/// The scene of some bytes.
///
/// # Errors
/// [`UnpackError`] if [`pack`] of this version didn't make them.
pub fn unpack(bytes: &[u8]) -> Result<Scene, UnpackError> {
    let packed: PackedScene<'static> = value_of(bytes)?;
    let images: Vec<Arc<Image>> =
        packed.images.into_iter().map(|image| Arc::new(image.into_owned())).collect();
    let textures = packed.textures.into_iter().enumerate().map(|(number, (image, sampler))| {
        let image = images.get(image as usize);
        let image = image.ok_or_else(|| UnpackError::Dangling(format!("texture {number}")))?;
        Ok(Texture { image: Arc::clone(image), sampler })
    });
    let scene = Scene {
        nodes: packed.nodes.into_owned(),
        meshes: packed.meshes.into_owned(),
        materials: packed.materials.into_owned(),
        textures: textures.collect::<Result<_, UnpackError>>()?,
        cameras: packed.cameras.into_owned(),
        lights: packed.lights.into_owned(),
        environment: packed.environment.into_owned(),
        ambient: packed.ambient,
        fog: packed.fog,
        background: packed.background,
        up: packed.up,
    };
    scene.check()?;
    Ok(scene)
}

/// A view as bytes, which [`unpack_view`] of the same version reads.
#[must_use]
pub fn pack_view(view: &View) -> Vec<u8> {
    bytes_of(view)
}

/// The view of some bytes.
///
/// # Errors
/// [`UnpackError`] if [`pack_view`] of this version didn't make them.
pub fn unpack_view(bytes: &[u8]) -> Result<View, UnpackError> {
    let view: View = value_of(bytes)?;
    check_environment(view.environment.is_sound())?;
    Ok(view)
}

/// How the map that a view lacks stands in its world: right, up and front, and degrees about up.
type Orientation = ([DVec3; 3], f64);

/// A view as bytes, but for the map of its environment: for many views with one map of many megabytes, which
/// [`pack_map`] packs once.
#[must_use]
pub fn pack_view_without_map(view: &View) -> Vec<u8> {
    let orientation: Option<Orientation> = view
        .environment
        .map()
        .map(|map| (map.frame().map(DVec3::from_array), map.rotation_degrees()));
    match orientation {
        Some(_) => {
            bytes_of(&(view.clone().with_environment(EnvironmentChoice::default()), orientation))
        }
        None => bytes_of(&(view, orientation)),
    }
}

/// The view of some bytes, with the map that it had.
///
/// # Errors
/// [`UnpackError`] if [`pack_view_without_map`] of this version didn't make them, and where the view had a map and none
/// is given.
pub fn unpack_view_with_map(
    bytes: &[u8],
    map: Option<&Arc<EnvironmentMap>>,
) -> Result<View, UnpackError> {
    let (view, orientation): (View, Option<Orientation>) = value_of(bytes)?;
    check_environment(view.environment.is_sound())?;
    let Some((frame, degrees)) = orientation else { return Ok(view) };
    let map = map.ok_or_else(|| UnpackError::Dangling("the view's environment".to_owned()))?;
    Ok(view.with_environment(EnvironmentChoice::of_map(Arc::clone(map), frame, degrees)))
}

/// The map of an environment as bytes, which [`unpack_map`] of the same version reads.
#[must_use]
pub fn pack_map(map: &EnvironmentMap) -> Vec<u8> {
    bytes_of(map)
}

/// The map of some bytes.
///
/// # Errors
/// [`UnpackError`] if [`pack_map`] of this version didn't make them.
pub fn unpack_map(bytes: &[u8]) -> Result<EnvironmentMap, UnpackError> {
    let map: EnvironmentMap = value_of(bytes)?;
    check_environment(map.is_sound())?;
    Ok(map)
}

fn check_environment(is_sound: bool) -> Result<(), UnpackError> {
    let lacks = || UnpackError::Dangling("the environment's map".to_owned());
    if is_sound { Ok(()) } else { Err(lacks()) }
}

fn bytes_of(value: &impl Serialize) -> Vec<u8> {
    // Memory is all that could be missing.
    postcard::to_extend(value, HEADER.as_bytes().to_vec()).unwrap_or_default()
}

fn value_of<T: DeserializeOwned>(bytes: &[u8]) -> Result<T, UnpackError> {
    let rest = bytes.strip_prefix(HEADER.as_bytes()).ok_or(UnpackError::Version)?;
    let (value, rest) = postcard::take_from_bytes(rest).map_err(UnpackError::Damaged)?;
    match rest {
        [] => Ok(value),
        _ => Err(UnpackError::Damaged(postcard::Error::DeserializeBadEncoding)),
    }
}
