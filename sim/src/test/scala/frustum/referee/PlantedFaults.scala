package frustum.referee

import frustum.contract.raster.{DepthFunction, PackedVertex, RasterConfig, RenderState, Wrap}
import frustum.driver.linear.{Matrix4, Vector3}
import frustum.driver.raster.{DrawOptions, Driver, PreparedFrame}
import frustum.driver.scene.{Camera, MeshVertex, Scene, Triangle}
import frustum.judge.EndToEndJudge
import frustum.scene.Scenes
import scala.math.{atan, tan, toDegrees, toRadians}

/** What a user asks for, and the driver's answer to it. */
final case class Request(
    scene: Scene,
    options: DrawOptions,
    config: RasterConfig = RasterConfig(width = 120, height = 160)
) {
  def prepare: PreparedFrame = Driver.prepare(scene, scene.camera, options, config, 0)

  def view: WorldView = EndToEndJudge.view(scene, scene.camera, options, config)
}

/** A fault of a driver, planted by changing what goes into the real one or what comes out of it. */
final case class Fault(name: String, asked: Request, faulty: PreparedFrame)

object PlantedFaults {
  private val plain = DrawOptions(None, cullBack = false, Wrap.Repeat, 0x304050)
  private val lit = plain.copy(light = Some(Vector3(3, 2, 1)))
  private val teapot = Request(Scenes.teapot(), plain)
  private val cube = Request(Scenes.cube, plain)
  private val corridor = Request(Scenes.byName("corridor"), plain)
  private val floor = Request(Scenes.floor, plain)
  private val turned = Request(Scenes.cube, lit.copy(turnDegrees = 25))

  /** The near plane goes through it. */
  private val cutOpen = cube.copy(scene = cube.scene.copy(camera = cube.scene.camera.copy(near = 3.6)))

  private def ahead(c: Camera, v: MeshVertex) =
    (v.position - c.eye).dot((c.at - c.eye).normalized)

  private def vertices(f: PreparedFrame)(change: PackedVertex => PackedVertex): PreparedFrame =
    f.copy(passes = f.passes.map(p => p.copy(vertices = p.vertices.map(change))))

  private def states(f: PreparedFrame)(change: RenderState => RenderState): PreparedFrame =
    f.copy(passes = f.passes.map(p => p.copy(states = p.states.map(change))))

  /** As after a change that turns triangles round, so that the hardware draws them again. */
  private def mirrored(f: PreparedFrame)(change: PackedVertex => PackedVertex): PreparedFrame = {
    val turned = f.passes.map(p => p.copy(triangles = p.triangles.map(t => t.copy(v1 = t.v2, v2 = t.v1))))
    vertices(f.copy(passes = turned))(change)
  }

  private def positions(s: Scene)(change: Vector3 => Vector3): Scene = {
    def moved(v: MeshVertex) = v.copy(position = change(v.position))
    s.copy(triangles = s.triangles.map(t => t.copy(v0 = moved(t.v0), v1 = moved(t.v1), v2 = moved(t.v2))))
  }

  private def aboutY(v: Vector3, degrees: Double) = Matrix4.rotationY(toRadians(degrees)).direction(v)

  private def prepared(r: Request)(change: Request => Request): PreparedFrame = change(r).prepare

  private def seenBy(r: Request)(change: Camera => Camera): PreparedFrame =
    prepared(r)(_.copy(scene = r.scene.copy(camera = change(r.scene.camera))))

  private def reversed(t: Triangle) = t.copy(v1 = t.v2, v2 = t.v1)

  private def lightFrom(r: Request)(change: Vector3 => Vector3) =
    prepared(r)(_.copy(options = r.options.copy(light = r.options.light.map(change))))

  private def blendedReversed(f: PreparedFrame): PreparedFrame = {
    val changed = f.passes.zip(f.sources).map { case (pass, sources) =>
      val (blended, opaque) = pass.triangles.zip(sources).partition { case (t, _) => pass.states(t.state).blend }
      val order = opaque ++ blended.reverse
      (pass.copy(triangles = order.map(_._1)), order.map(_._2))
    }
    f.copy(passes = changed.map(_._1), sources = changed.map(_._2))
  }

  /** The wrong way round, on both sides of the half. */
  private def otherWay(fov: Double, aspect: Double) = 2 * toDegrees(atan(tan(toRadians(fov) / 2) * aspect))

  /** The whole of what a pass reads, its textures changing places. */
  private def swappedTextures(f: PreparedFrame): PreparedFrame = {
    val found = f.passes.flatMap(_.states).flatMap(_.texture).distinct
    states(f)(s => s.copy(texture = s.texture.map(t => found((found.indexOf(t) + 1) % found.length))))
  }

  lazy val all: Seq[Fault] = Seq(
    "culling: the front faces go" -> { r: Request =>
      prepared(r)(q => q.copy(scene = q.scene.copy(triangles = q.scene.triangles.map(reversed))))
    } -> Request(Scenes.teapot(), plain.copy(cullBack = true)),
    "viewport: y upwards" -> { r: Request =>
      mirrored(r.prepare)(v => v.copy(y = r.config.height * 16 - v.y))
    } -> teapot,
    "viewport: half a pixel to the right" -> { r: Request => vertices(r.prepare)(v => v.copy(x = v.x + 8)) } -> cube,
    "look-at: left-handed" -> { r: Request =>
      mirrored(r.prepare)(v => v.copy(x = r.config.width * 16 - v.x))
    } -> teapot,
    "look-at: up is ignored" -> { r: Request => seenBy(r)(_.copy(up = Vector3(0, 1, 0))) } -> cube.copy(scene =
      cube.scene.copy(camera = cube.scene.camera.copy(up = Vector3(1, 2, 0)))
    ),
    "field of view: the horizontal one" -> { r: Request =>
      seenBy(r)(c => c.copy(fovDegrees = otherWay(c.fovDegrees, r.config.height.toDouble / r.config.width)))
    } -> teapot,
    "aspect: width and height in each other's place" -> { r: Request =>
      val k = (r.config.width.toDouble / r.config.height) * (r.config.width.toDouble / r.config.height)
      vertices(r.prepare)(v => v.copy(x = (r.config.width * 8 + (v.x - r.config.width * 8) * k).round.toInt))
    } -> cube,
    "near plane: does not cut" -> { r: Request => seenBy(r)(_.copy(near = 1)) } -> cutOpen,
    "near plane: what crosses it is left out" -> { r: Request =>
      prepared(r)(q =>
        q.copy(scene = q.scene.copy(triangles = q.scene.triangles.map { t =>
          if (t.vertices.exists(v => ahead(q.scene.camera, v) < q.scene.camera.near)) t.copy(v1 = t.v0, v2 = t.v0)
          else t
        }))
      )
    } -> cutOpen,
    "far plane: at a third of its distance" -> { r: Request => seenBy(r)(c => c.copy(far = c.far / 3)) } -> floor,
    "depth: far is near" -> { r: Request => vertices(r.prepare)(v => v.copy(z = 65535 - v.z)) } -> teapot,
    "depth: no test" -> { r: Request => states(r.prepare)(_.copy(depth = DepthFunction.Always)) } -> teapot,
    "depth: nothing written" -> { r: Request => states(r.prepare)(_.copy(depthWrite = false)) } -> teapot,
    "texture: v downwards" -> { r: Request => vertices(r.prepare)(v => v.copy(t = 65536 - v.t)) } -> cube,
    "texture: s and t in each other's place" -> { r: Request =>
      vertices(r.prepare)(v => v.copy(s = v.t, t = v.s))
    } -> cube,
    "texture: not perspective" -> { r: Request =>
      vertices(r.prepare)(v => v.copy(qMantissa = 1 << 15, qExponent = 0))
    } -> floor,
    "textures: another material's" -> { r: Request => swappedTextures(r.prepare) } -> corridor,
    "wrap mode of s: mirror" -> { r: Request => states(r.prepare)(s => s.copy(wrapS = Wrap.Mirror)) } -> floor,
    "wrap mode of t: clamp" -> { r: Request => states(r.prepare)(s => s.copy(wrapT = Wrap.Clamp)) } -> floor,
    "light: from the other side" -> { r: Request => lightFrom(r)(l => -l) } -> turned,
    "light: turns with the model" -> { r: Request => lightFrom(r)(aboutY(_, 25)) } -> turned,
    "light: in the eye's space" -> { r: Request =>
      val c = r.scene.camera
      val axes = Matrix4.lookAt(c.eye, c.at, c.up).rows.take(3).map(row => Vector3(row(0), row(1), row(2)))
      lightFrom(r)(l => axes.zip(l.axes).map { case (axis, along) => axis * along }.reduce(_ + _))
    } -> turned,
    "matrices: turned about the origin" -> { r: Request =>
      prepared(r)(q =>
        q.copy(
          scene = positions(q.scene)(aboutY(_, q.options.turnDegrees)),
          options = q.options.copy(turnDegrees = 0)
        )
      )
    } -> Request(Scenes.teapot(), plain.copy(turnDegrees = 40)),
    "matrices: turned the other way" -> { r: Request =>
      prepared(r)(q => q.copy(options = q.options.copy(turnDegrees = -q.options.turnDegrees)))
    } -> Request(Scenes.teapot(), plain.copy(turnDegrees = 40)),
    "blending: front to back" -> { r: Request => blendedReversed(r.prepare) } -> corridor,
    "blending: left out" -> { r: Request => states(r.prepare)(_.copy(blend = false)) } -> corridor,
    "alpha test: left out" -> { r: Request => states(r.prepare)(_.copy(alphaRef = 0)) } -> corridor,
    "colours: red and blue in each other's place" -> { r: Request =>
      vertices(r.prepare)(v => v.copy(r = v.b, b = v.r))
    } -> teapot,
    "orthographic: half of the height" -> { r: Request =>
      seenBy(r)(c => c.copy(orthoHeight = c.orthoHeight.map(_ / 2)))
    } -> cube.copy(scene = cube.scene.copy(camera = cube.scene.camera.copy(orthoHeight = Some(2.5))))
  ).map { case ((name, plant), asked) => Fault(name, asked, plant(asked)) }
}
