//! The rest pose: morph targets at their default weights, skins bound to their joints' nodes
//! (glTF 2.0 specification, sections 3.7.2.2 and 3.7.3).

use super::buffers::malformed;
use super::vertices::{Source, Vertices};
use crate::Error;
use luxel_scene::{DMat3, DMat4, DVec3};

/// The deformation of a mesh at one node.
#[derive(Debug, Default)]
pub(crate) struct Pose {
    /// The weights of the morph targets.
    pub(crate) weights: Vec<f64>,
    /// For each joint, from the mesh's coordinates in the bind pose to the node's; `None` without
    /// a skin. Excludes the node's transform, which doesn't apply to a skinned mesh.
    pub(crate) joints: Option<Vec<DMat4>>,
}

/// Adds the weighted displacements of the morph targets.
pub(crate) fn morph(
    vertices: &mut Vertices,
    source: &Source<'_, '_>,
    pose: &Pose,
) -> Result<(), Error> {
    let count = vertices.positions.len();
    let mut moved_normals = false;
    for (number, (target, &weight)) in
        source.primitive.targets.iter().zip(&pose.weights).enumerate()
    {
        if weight == 0.0 {
            continue;
        }
        let of = |name| source.displacements(target, number, name, count);
        if let Some(displacements) = of("POSITION")? {
            for (position, by) in vertices.positions.iter_mut().zip(&displacements) {
                *position = [0, 1, 2].map(|axis| position[axis] + weight * by[axis]);
            }
        }
        if !vertices.normals.is_empty()
            && let Some(displacements) = of("NORMAL")?
        {
            moved_normals = true;
            for (normal, by) in vertices.normals.iter_mut().zip(&displacements) {
                *normal = [0, 1, 2].map(|axis| normal[axis] + (weight * by[axis]) as f32);
            }
        }
        if !vertices.tangents.is_empty()
            && let Some(displacements) = of("TANGENT")?
        {
            for (tangent, by) in vertices.tangents.iter_mut().zip(&displacements) {
                for axis in 0..3 {
                    tangent[axis] += (weight * by[axis]) as f32;
                }
            }
        }
    }
    if moved_normals {
        vertices.normals.iter_mut().for_each(|normal| *normal = unit(widened(*normal)));
    }
    Ok(())
}

/// Linear blend skinning: the weighted mean of each vertex under its joints' transforms.
pub(crate) fn skin(
    vertices: &mut Vertices,
    joints: &[DMat4],
    source: &Source<'_, '_>,
) -> Result<(), Error> {
    for vertex in 0..vertices.positions.len() {
        let mut mean = [0.0; 16];
        let mut sum = 0.0;
        for (set, four) in vertices.influences.iter().enumerate() {
            for (&joint, &weight) in four.joints[vertex].iter().zip(&four.weights[vertex]) {
                if weight == 0.0 {
                    continue;
                }
                let Some(matrix) = joints.get(joint as usize) else {
                    let pointer = format!("{}/attributes/JOINTS_{set}", source.pointer);
                    let there = joints.len();
                    let message =
                        format!("vertex {vertex} uses joint {joint}, but the skin has {there}");
                    return Err(malformed(pointer, message));
                };
                let weight = f64::from(weight);
                sum += weight;
                for (entry, part) in mean.iter_mut().zip(matrix.to_cols_array()) {
                    *entry += weight * part;
                }
            }
        }
        // Weights should add up to 1; quantized ones nearly do. A vertex without any stays.
        if sum == 0.0 || !sum.is_finite() {
            continue;
        }
        let node_from_mesh = DMat4::from_cols_array(&mean.map(|entry| entry / sum));
        let position = DVec3::from_array(vertices.positions[vertex]);
        vertices.positions[vertex] = node_from_mesh.transform_point3(position).to_array();
        let linear = DMat3::from_mat4(node_from_mesh);
        if let Some(normal) = vertices.normals.get_mut(vertex) {
            *normal = unit(normal_matrix(&linear) * widened(*normal));
        }
        if let Some([x, y, z, _]) = vertices.tangents.get_mut(vertex) {
            [*x, *y, *z] = unit(linear * widened([*x, *y, *z]));
        }
    }
    Ok(())
}

/// The inverse transpose, up to a positive factor: the cofactors, with the determinant's sign.
fn normal_matrix(linear: &DMat3) -> DMat3 {
    let [x, y, z] = [linear.x_axis, linear.y_axis, linear.z_axis];
    let cofactors = DMat3::from_cols(y.cross(z), z.cross(x), x.cross(y));
    if linear.determinant() < 0.0 { -cofactors } else { cofactors }
}

fn widened(vector: [f32; 3]) -> DVec3 {
    DVec3::from_array(vector.map(f64::from))
}

/// The normalized vector, or zero, which marks a missing one.
fn unit(vector: DVec3) -> [f32; 3] {
    vector.normalize_or_zero().as_vec3().to_array()
}
