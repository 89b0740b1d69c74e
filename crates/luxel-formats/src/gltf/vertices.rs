//! The vertex attributes of one primitive, converted to luxel's types.

use super::accessor::{self, Elements};
use super::buffers::{Buffers, malformed};
use super::draco::Decoded;
use crate::{Error, Place};
use luxel_gltf::{Index, Primitive};
use std::collections::BTreeMap;

/// Upper bound of the bytes per vertex, while reading and in the mesh.
const BYTES_PER_VERTEX: u64 = 160;

/// Attributes, each empty or as long as the positions.
#[derive(Debug, Default)]
pub(crate) struct Vertices {
    pub(crate) positions: Vec<[f64; 3]>,
    pub(crate) normals: Vec<[f32; 3]>,
    pub(crate) tangents: Vec<[f32; 4]>,
    pub(crate) uvs: [Vec<[f32; 2]>; 2],
    pub(crate) colors: Vec<[f32; 4]>,
    /// Joints and weights, in sets of four.
    pub(crate) influences: Vec<Influences>,
}

/// Up to four joints per vertex, with their weights.
#[derive(Debug)]
pub(crate) struct Influences {
    pub(crate) joints: Vec<[u32; 4]>,
    pub(crate) weights: Vec<[f32; 4]>,
}

/// The source of a primitive's attributes.
pub(crate) struct Source<'s, 'd> {
    pub(crate) buffers: &'s Buffers<'d>,
    pub(crate) primitive: &'d Primitive,
    pub(crate) pointer: &'s str,
    pub(crate) draco: Option<&'s Decoded>,
}

impl Source<'_, '_> {
    /// Reads all attributes; `None` without positions, which drawing needs.
    pub(crate) fn vertices(&self) -> Result<Option<Vertices>, Error> {
        let Some(positions) = self.positions()? else { return Ok(None) };
        let count = positions.len();
        let mut vertices = Vertices { positions, ..Vertices::default() };
        vertices.normals = self.attribute("NORMAL", count)?;
        vertices.tangents = self.attribute("TANGENT", count)?;
        vertices.uvs = [self.attribute("TEXCOORD_0", count)?, self.attribute("TEXCOORD_1", count)?];
        vertices.colors = self.colors(count)?;
        vertices.influences = self.influences(count)?;
        Ok(Some(vertices))
    }

    fn positions(&self) -> Result<Option<Vec<[f64; 3]>>, Error> {
        let memory = self.buffers.memory();
        let pointer = || self.attribute_pointer("POSITION");
        let place = || Place::Pointer(pointer());
        if let Some(values) = self.compressed("POSITION", 3)? {
            memory.take("vertices", values.len() as u64 / 3, BYTES_PER_VERTEX, place())?;
            let positions = values.as_chunks::<3>().0.iter();
            return Ok(Some(positions.map(|position| position.map(f64::from)).collect()));
        }
        let Some(elements) = self.elements("POSITION")? else { return Ok(None) };
        memory.take("vertices", elements.count as u64, BYTES_PER_VERTEX, place())?;
        elements.vectors().map(Some).map_err(|message| malformed(pointer(), message))
    }

    /// An attribute of `count` vertices; empty if the primitive lacks it.
    fn attribute<const N: usize>(&self, name: &str, count: usize) -> Result<Vec<[f32; N]>, Error> {
        if let Some(values) = self.compressed(name, N)? {
            return self.of_length(values.as_chunks::<N>().0.to_vec(), name, count);
        }
        let Some(elements) = self.elements(name)? else { return Ok(Vec::new()) };
        let values = elements.vectors_f32();
        let values = values.map_err(|text| malformed(self.attribute_pointer(name), text))?;
        self.of_length(values, name, count)
    }

    /// Colours have three or four components; missing alpha is 1.
    fn colors(&self, count: usize) -> Result<Vec<[f32; 4]>, Error> {
        const NAME: &str = "COLOR_0";
        let opaque = |[red, green, blue]: [f32; 3]| [red, green, blue, 1.0];
        let width = match self.draco.and_then(|draco| self.decompressed(draco, NAME)) {
            Some((width, _)) => Some(width),
            None => self.elements(NAME)?.map(|elements| elements.width),
        };
        match width {
            None => Ok(Vec::new()),
            Some(3) => Ok(self.attribute(NAME, count)?.into_iter().map(opaque).collect()),
            Some(_) => self.attribute(NAME, count),
        }
    }

    fn influences(&self, count: usize) -> Result<Vec<Influences>, Error> {
        let mut influences = Vec::new();
        for set in 0_u32.. {
            let (joints_name, weights_name) = (format!("JOINTS_{set}"), format!("WEIGHTS_{set}"));
            let attributes = &self.primitive.attributes;
            if !attributes.contains_key(&joints_name) || !attributes.contains_key(&weights_name) {
                break;
            }
            let place = || Place::Pointer(self.attribute_pointer(&joints_name));
            self.buffers.memory().take("joints", count as u64, 32, place())?;
            let joints = match self.compressed(&joints_name, 4)? {
                Some(values) => {
                    let fours = values.as_chunks::<4>().0.iter();
                    fours.map(|joints| joints.map(|joint| joint as u32)).collect()
                }
                None => match self.elements(&joints_name)? {
                    Some(elements) => elements.joints().map_err(|message| {
                        malformed(self.attribute_pointer(&joints_name), message)
                    })?,
                    None => break,
                },
            };
            let joints = self.of_length(joints, &joints_name, count)?;
            let weights = self.attribute(&weights_name, count)?;
            influences.push(Influences { joints, weights });
        }
        Ok(influences)
    }

    fn decompressed(&self, draco: &Decoded, name: &str) -> Option<(usize, Vec<f32>)> {
        draco.values(self.buffers, self.primitive, name)
    }

    /// The values of an attribute in the Draco stream, if present.
    fn compressed(&self, name: &str, wanted: usize) -> Result<Option<Vec<f32>>, Error> {
        let Some((width, values)) = self.draco.and_then(|draco| self.decompressed(draco, name))
        else {
            return Ok(None);
        };
        if width == wanted {
            return Ok(Some(values));
        }
        let message = format!("elements have {width} components instead of {wanted}");
        Err(malformed(self.attribute_pointer(name), message))
    }

    fn elements(&self, name: &str) -> Result<Option<Elements<'_>>, Error> {
        let Some(&index) = self.primitive.attributes.get(name) else { return Ok(None) };
        accessor::elements(self.buffers, index, &|| self.attribute_pointer(name)).map(Some)
    }

    fn of_length<T>(&self, mut values: Vec<T>, name: &str, count: usize) -> Result<Vec<T>, Error> {
        if values.len() < count {
            let message = format!("there are {} values for {count} positions", values.len());
            return Err(malformed(self.attribute_pointer(name), message));
        }
        values.truncate(count);
        Ok(values)
    }

    fn attribute_pointer(&self, name: &str) -> String {
        format!("{}/attributes/{name}", self.pointer)
    }

    /// The displacements of an attribute by a morph target, if it has any.
    pub(crate) fn displacements(
        &self,
        target: &BTreeMap<String, Index>,
        number: usize,
        name: &str,
        count: usize,
    ) -> Result<Option<Vec<[f64; 3]>>, Error> {
        let Some(&index) = target.get(name) else { return Ok(None) };
        let pointer = || format!("{}/targets/{number}/{name}", self.pointer);
        let elements = accessor::elements(self.buffers, index, &pointer)?;
        let place = || Place::Pointer(pointer());
        self.buffers.memory().take("morph targets", elements.count as u64, 24, place())?;
        let values = elements.vectors().map_err(|message| malformed(pointer(), message))?;
        if values.len() < count {
            let message = format!("there are {} values for {count} positions", values.len());
            return Err(malformed(pointer(), message));
        }
        Ok(Some(values))
    }
}
