package frustum.driver.raster

import frustum.contract.raster.{
  BeginLayout,
  Command,
  FramePass,
  PackedVertex,
  TexelsHeadLayout,
  TextureUpload,
  TriangleLayout
}

/** Passes and textures as wire commands, each as full as [[Command.MaxWords]] allows. */
object CommandEncoder {
  private val verticesPerCommand = (Command.MaxWords - 1) / PackedVertex.WireWords
  private val trianglesPerCommand = (Command.MaxWords - 1) / TriangleLayout.words

  private val TexelUnit = TexelsHeadLayout.Unit
  private val texelsPerCommand = (Command.MaxWords - 1) / TexelUnit * TexelUnit

  /** begin, states, vertices, triangles, draw: a triangle never comes before its vertices. */
  def pass(pass: FramePass): Seq[Seq[Int]] = {
    val r = pass.region
    val begin = Command.encode(
      Command.Begin,
      BeginLayout.encode(
        BeginLayout.Frame -> (pass.frame & BeginLayout.Frame.ones),
        BeginLayout.ClearColor -> pass.clearColor,
        BeginLayout.X0 -> r.x0,
        BeginLayout.X1 -> r.x1,
        BeginLayout.Y0 -> r.y0,
        BeginLayout.Y1 -> r.y1
      )
    )
    val states = pass.states.zipWithIndex.map { case (s, i) => Command.encode(Command.State, i +: s.words) }
    val vertices = pass.vertices.grouped(verticesPerCommand).zipWithIndex.map { case (group, i) =>
      Command.encode(Command.Vertices, i * verticesPerCommand +: group.flatMap(_.words))
    }
    val triangles = runs(pass.triangles.map(_.state)).flatMap { case (state, from, until) =>
      pass.triangles.slice(from, until).grouped(trianglesPerCommand).map { group =>
        Command.encode(Command.Triangles, state +: group.flatMap(_.words))
      }
    }
    val draw = Command.encode(Command.Draw, Seq(pass.vertices.length, pass.triangles.length))
    Seq(begin) ++ states ++ vertices ++ triangles ++ Seq(draw)
  }

  def upload(upload: TextureUpload): Seq[Seq[Int]] = {
    val first = upload.base * (TextureMemory.Unit / TexelUnit)
    upload.texels
      .grouped(texelsPerCommand)
      .zipWithIndex
      .map { case (group, i) =>
        Command.encode(Command.Texels, (first + i * texelsPerCommand / TexelUnit) +: group)
      }
      .toSeq
  }

  /** Stretches of equal values: value, first index, index after the last. */
  private def runs(values: IndexedSeq[Int]): Seq[(Int, Int, Int)] = {
    val starts = values.indices.filter(i => i == 0 || values(i) != values(i - 1))
    starts.zip(starts.drop(1) :+ values.length).map { case (a, b) => (values(a), a, b) }
  }
}
