//! Traversal: single rays, rays that take turns, packets, and batches of all of them.

mod any_packet;
mod batch;
mod box_items;
mod columns;
mod group;
mod packet;
mod packet_kind;
mod packet_traversal;
mod query;
mod sheared_interval;
mod single_ray;
mod stack;
mod target;

pub(crate) use batch::{trace_batch, trace_here};
pub(crate) use box_items::visit_items;
pub(crate) use columns::any_of_columns;
pub(crate) use query::{AnyHit, ClosestHit, RayQuery};
pub(crate) use single_ray::{RaySetup, RaySlabs, set_up, trace_unusual, trace_usual};
pub(crate) use target::RayTarget;
